// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/free_decay/decay_covariance.h"

#include "fathom/noise/fit_noise.h"
#include "fathom/signal/filters/autoregression.h"
#include "fathom/solve/decompositions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace fathom {
namespace {

// As docs/output_error.md (7) has it.
double FactorOfFreedom(const Autoregression& noise, const Eigen::VectorXd& psi, double unknowns) {
  const auto n = static_cast<double>(psi.size());
  double sum = 1.0;
  for (const double phi : noise.coefficients) sum -= phi;
  const double shrink =
      noise.innovation_variance > 0.0
          ? std::min(1.0, psi.squaredNorm() / n * sum * sum / noise.innovation_variance)
          : 1.0;
  const double effective = std::max(n * shrink, 2.0 * unknowns);
  return effective / (effective - unknowns);
}

// White noise and noise that fades exponentially, by their restricted likelihood: unlike an
// autoregression of the residuals it knows what the fit took out of them, which of a short decay is
// most of its slow noise. Nothing if the search does not converge.
std::optional<SensorNoise> RestrictedNoise(std::span<const DecayStretch> stretches,
                                           const Eigen::VectorXd& psi,
                                           const Eigen::MatrixXd& J) {
  std::vector<NoiseSample> samples;
  for (std::size_t s = 0; s < stretches.size(); ++s) {
    for (const double t : stretches[s].time) {
      samples.push_back({.time = t, .segment = static_cast<int>(s)});
    }
  }
  const double rms = std::sqrt(psi.squaredNorm() / static_cast<double>(psi.size()));
  if (!(rms > 0.0)) return std::nullopt;
  const std::vector<double>& time = stretches.front().time;
  const double duration = time.back() - time.front();
  FitNoiseOptions options;
  options.start.emplace();
  options.start->velocity = {.white_std = 0.8 * rms,
                             .coloured = {.std = 0.6 * rms, .time = duration / 20.0}};
  const NoiseFit fit = FitNoise(samples,
                                std::span(psi.data(), static_cast<std::size_t>(psi.size())),
                                RowMajorMatrix(J),
                                options);
  if (!fit.IsUsable()) return std::nullopt;
  return fit.model.velocity;
}

// J' Gamma J of such noise.
Eigen::MatrixXd GramUnder(const SensorNoise& noise,
                          std::span<const DecayStretch> stretches,
                          const Eigen::MatrixXd& J) {
  const double variance = noise.coloured.std * noise.coloured.std;
  Eigen::MatrixXd gram = (noise.white_std * noise.white_std + variance) * (J.transpose() * J);
  Eigen::Index row = 0;
  for (const DecayStretch& stretch : stretches) {
    Eigen::VectorXd before = Eigen::VectorXd::Zero(J.cols());
    for (std::size_t i = 0; i < stretch.time.size(); ++i, ++row) {
      const Eigen::VectorXd now = J.row(row).transpose();
      if (i > 0) {
        before *= std::exp(-(stretch.time[i] - stretch.time[i - 1]) / noise.coloured.time);
        const Eigen::MatrixXd product = variance * now * before.transpose();
        gram += product + product.transpose();
      }
      before += now;
    }
  }
  return gram;
}

}  // namespace

Eigen::Matrix4d DecayCovariance(std::span<const DecayStretch> stretches,
                                const DecayResiduals& residuals,
                                const std::vector<int>& fixed,
                                double clip,
                                int max_order) {
  // Of columns of length 1; a direction below it is not told.
  constexpr double kSmallestEigenvalue = 1e-12;
  const Eigen::MatrixXd& all = residuals.jacobian;
  std::vector<Eigen::Index> columns;
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();
  for (Eigen::Index j = 0; j < all.cols(); ++j) {
    if (std::ranges::count(fixed, static_cast<int>(j)) > 0) continue;
    if (all.col(j).squaredNorm() > 0.0) {
      columns.push_back(j);
    } else if (j < kNumDecayRates) {
      covariance(j, j) = std::numeric_limits<double>::infinity();
    }
  }
  const auto num_columns = static_cast<Eigen::Index>(columns.size());
  const Eigen::Index n = all.rows();
  Eigen::MatrixXd J(n, num_columns);
  Eigen::VectorXd length(num_columns);
  for (Eigen::Index k = 0; k < num_columns; ++k) {
    length[k] = all.col(columns[static_cast<std::size_t>(k)]).norm();
    J.col(k) = all.col(columns[static_cast<std::size_t>(k)]) / length[k];
  }

  Eigen::VectorXd psi(n);
  Eigen::VectorXd inside(n);
  std::vector<std::vector<double>> pieces;
  for (std::size_t s = 0; s + 1 < residuals.begin.size(); ++s) {
    for (Eigen::Index i = residuals.begin[s]; i < residuals.begin[s + 1]; ++i) {
      psi[i] = std::clamp(residuals.residual[i], -clip, clip);
      inside[i] = std::abs(residuals.residual[i]) <= clip ? 1.0 : 0.0;
    }
    pieces.emplace_back(psi.data() + residuals.begin[s], psi.data() + residuals.begin[s + 1]);
  }
  const int order = std::min(max_order, static_cast<int>(n / 10));
  const Autoregression noise =
      psi.squaredNorm() > 0.0 ? FitAutoregression(std::move(pieces), order) : Autoregression();
  ColouredGram coloured(noise, num_columns);
  Eigen::MatrixXd B = Eigen::MatrixXd::Zero(num_columns, num_columns);
  for (std::size_t s = 0; s + 1 < residuals.begin.size(); ++s) {
    coloured.Add(J.middleRows(residuals.begin[s], residuals.begin[s + 1] - residuals.begin[s]));
    B += coloured.EndPiece();
  }
  const SymmetricEigen A = EigenOf(J.transpose() * inside.asDiagonal() * J);
  const double floor = kSmallestEigenvalue * A.values.maxCoeff();
  const Eigen::VectorXd inverse = A.values.cwiseMax(floor).cwiseInverse();
  const Eigen::MatrixXd A_inverse = A.vectors * inverse.asDiagonal() * A.vectors.transpose();
  Eigen::MatrixXd C =
      FactorOfFreedom(noise, psi, static_cast<double>(num_columns)) * A_inverse * B * A_inverse;
  if (const auto restricted = RestrictedNoise(stretches, psi, J)) {
    const Eigen::MatrixXd other = A_inverse * GramUnder(*restricted, stretches, J) * A_inverse;
    const Eigen::VectorXd wider =
        (other.diagonal().array() / C.diagonal().array()).max(1.0).sqrt().matrix();
    if (wider.allFinite()) C = wider.asDiagonal() * C * wider.asDiagonal();
  }
  for (Eigen::Index k = 0; k < num_columns; ++k) {
    for (Eigen::Index l = 0; l < num_columns; ++l) {
      const auto i = columns[static_cast<std::size_t>(k)], j = columns[static_cast<std::size_t>(l)];
      if (i >= kNumDecayRates || j >= kNumDecayRates) continue;
      covariance(i, j) = C(k, l) / (length[k] * length[l]);
    }
  }
  for (Eigen::Index e = 0; e < num_columns; ++e) {
    if (A.values[e] > floor) continue;
    for (Eigen::Index k = 0; k < num_columns; ++k) {
      const auto i = columns[static_cast<std::size_t>(k)];
      if (i < kNumDecayRates && std::abs(A.vectors(k, e)) > 1e-3) {
        covariance(i, i) = std::numeric_limits<double>::infinity();
      }
    }
  }
  return covariance;
}

}  // namespace fathom
