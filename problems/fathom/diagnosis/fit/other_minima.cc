// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/fit/other_minima.h"

#include "fathom/base/parallel_for.h"
#include "fathom/diagnosis/fit/fit_with_noise.h"
#include "fathom/diagnosis/fit/parameter_bounds.h"
#include "fathom/diagnosis/fit/unknowns.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace fathom {
namespace {

constexpr std::array<double, 6> kStepsAside = {2.0, 4.0, 8.0, 16.0, 32.0, 64.0};  // [std]
constexpr int kMostRounds = 4;
constexpr double kHigher = 4.0;    // of chi squared: what is higher the data rule out
constexpr double kLikelier = 0.1;  // of the log-likelihood, at least
constexpr double kTheSame = 1.0;   // [std], apart

// Parameters that a response changes shape with, and that these data tell: their places among all.
std::vector<int> SizesIn(const StructureFit& fit) {
  std::vector<int> sizes;
  int i = kNumParameters;
  for (const ActiveEffect& active : fit.model.effects) {
    for (const EffectParameter& parameter : active.effect->info().parameters) {
      const bool is_told = !fit.is_on_bound[i] && fit.covariance(i, i) > 0.0;
      if (parameter.search == Search::kSize && is_told) sizes.push_back(i);
      ++i;
    }
  }
  return sizes;
}

Eigen::VectorXd ValuesOf(const TrainingData& data, const StructureFit& fit) {
  return Pack(data, fit.model, fit.initial).value.head(fit.covariance.rows());
}

// Whether two fits of a model have one minimum, by the standard deviations of the first.
bool AreOne(const TrainingData& data, const StructureFit& a, const StructureFit& b) {
  const Eigen::VectorXd apart = ValuesOf(data, b) - ValuesOf(data, a);
  const std::vector<int> sizes = SizesIn(a);
  return std::all_of(sizes.begin(), sizes.end(), [&](int i) {
    return std::abs(apart[i]) < kTheSame * std::sqrt(a.covariance(i, i));
  });
}

// The other minima that searches from either side end in and that the data do not rule out under
// the noise of the fit, the lowest first.
std::vector<StructureFit> MinimaBeside(const TrainingData& data, const StructureFit& fit) {
  const Unknowns unknowns = Pack(data, fit.model, fit.initial);
  std::vector<StructureFit> minima;
  for (const int i : SizesIn(fit)) {
    for (const double side : {-1.0, 1.0}) {
      for (const double step : kStepsAside) {
        Eigen::VectorXd value = unknowns.value;
        value[i] += side * step * std::sqrt(fit.covariance(i, i));
        if (!(value[i] > unknowns.lower[i] && value[i] < unknowns.upper[i])) break;
        StructureFit& aside = minima.emplace_back();
        aside.model = fit.model;
        aside.initial = fit.initial;
        Unpack(data, value, &aside.model, &aside.initial);
      }
    }
  }
  const Whitener whitener(fit.noise, data.samples());
  ParallelFor(static_cast<int>(minima.size()), [&](int k) {
    StructureFit& aside = minima[static_cast<std::size_t>(k)];
    aside = FitStructure(data, aside.model, aside.initial, whitener);
    aside.noise = fit.noise;
  });
  std::stable_sort(minima.begin(), minima.end(), [](const StructureFit& a, const StructureFit& b) {
    return a.chi_squared < b.chi_squared;
  });
  std::vector<StructureFit> others;
  for (StructureFit& aside : minima) {
    if (aside.chi_squared > fit.chi_squared + kHigher) break;
    const bool is_known = !aside.IsUsable() || AreOne(data, fit, aside) ||
                          std::any_of(others.begin(), others.end(), [&](const auto& other) {
                            return AreOne(data, other, aside);
                          });
    if (!is_known) others.push_back(std::move(aside));
  }
  return others;
}

// With the noise learned at each, as far as the first that is then likelier than the fit.
std::vector<StructureFit> LearnedAt(const TrainingData& data,
                                    const StructureFit& fit,
                                    const std::vector<StructureFit>& minima) {
  std::vector<StructureFit> learned;
  for (const StructureFit& minimum : minima) {
    StructureFit next = FitBy(Criterion::kLearnedNoise, data, minimum, {&fit.noise, 1});
    if (!next.IsUsable()) continue;
    learned.push_back(std::move(next));
    if (learned.back().log_likelihood > fit.log_likelihood + kLikelier) break;
  }
  return learned;
}

// Of the squares about the likeliest minimum, of itself and the others, each by its likelihood and
// as wide as the likeliest.
Eigen::MatrixXd CovarianceOfAll(const TrainingData& data,
                                const StructureFit& likeliest,
                                const std::vector<StructureFit>& others) {
  const Eigen::VectorXd at = ValuesOf(data, likeliest);
  Eigen::MatrixXd sum = likeliest.covariance;
  double weights = 1.0;
  for (const StructureFit& other : others) {
    if (AreOne(data, likeliest, other)) continue;
    const double weight = std::exp(other.log_likelihood - likeliest.log_likelihood);
    const Eigen::VectorXd apart = ValuesOf(data, other) - at;
    sum += weight * (likeliest.covariance + apart * apart.transpose());
    weights += weight;
  }
  Eigen::MatrixXd covariance = sum / weights;
  for (Eigen::Index i = 0; i < covariance.rows(); ++i) {
    if (!likeliest.is_on_bound[static_cast<std::size_t>(i)]) continue;
    covariance.row(i) = likeliest.covariance.row(i);
    covariance.col(i) = likeliest.covariance.col(i);
  }
  return covariance;
}

}  // namespace

StructureFit LikeliestMinimum(const TrainingData& data, StructureFit fit) {
  if (!fit.IsUsable() || SizesIn(fit).empty()) return fit;
  for (int round = 0;; ++round) {
    std::vector<StructureFit> others = LearnedAt(data, fit, MinimaBeside(data, fit));
    const bool moves_on = round < kMostRounds && !others.empty() &&
                          others.back().log_likelihood > fit.log_likelihood + kLikelier;
    if (!moves_on) {
      fit.covariance = CovarianceOfAll(data, fit, others);
      return fit;
    }
    fit = std::move(others.back());
  }
}

}  // namespace fathom
