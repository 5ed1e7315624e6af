// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/free_decay/free_decay.h"

#include "fathom/base/input_error.h"
#include "fathom/base/interval95.h"
#include "fathom/base/robust_std.h"
#include "fathom/free_decay/decay_covariance.h"
#include "fathom/free_decay/decay_guess.h"
#include "fathom/free_decay/decay_search.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glog/logging.h>

namespace fathom {
namespace {

constexpr std::array<const char*, kNumDecayRates> kNames = {
    "linear damping", "quadratic damping", "stiffness", "constant force"};

// As output error has it: at least what rounding leaves.
double SigmaOf(const Eigen::VectorXd& residual, double scale) {
  std::vector<double> size(static_cast<std::size_t>(residual.size()));
  for (std::size_t i = 0; i < size.size(); ++i) {
    size[i] = std::abs(residual[static_cast<Eigen::Index>(i)]);
  }
  return std::max(RobustStd(std::move(size)), 1e-10 * scale);
}

// The damping rate at the root mean square speed, in standard deviations: what tells a decay.
bool Decays(const FreeDecaySummary& summary, double speed) {
  const auto& C = summary.covariance;
  const double damping = summary.rates[kLinearRate] + speed * summary.rates[kQuadraticRate];
  const double variance = C(kLinearRate, kLinearRate) +
                          2.0 * speed * C(kLinearRate, kQuadraticRate) +
                          speed * speed * C(kQuadraticRate, kQuadraticRate);
  return damping > 0.0 && damping > kStdsOf95 * std::sqrt(std::max(variance, 0.0));
}

void AddCaveats(const FreeDecayOptions& options, FreeDecaySummary* summary) {
  for (const int rate : BoundedRates(options)) {
    const double value = summary->rates[static_cast<std::size_t>(rate)];
    const double half = kStdsOf95 * std::sqrt(summary->covariance(rate, rate));
    const char* const name = kNames[static_cast<std::size_t>(rate)];
    if (summary->on_bound[static_cast<std::size_t>(rate)]) {
      summary->caveats.push_back(
          fmt::format("The {} is on its bound 0: the data would have it negative.", name));
    } else if (half > value) {
      summary->caveats.push_back(fmt::format(
          "This decay does not determine the {}: its 95 % interval is wider than ± 100 % of its "
          "value. Decays from a higher speed tell quadratic damping, longer ones linear damping.",
          name));
    }
  }
}

}  // namespace

FreeDecaySummary FitFreeDecay(std::span<const DecayStretch> stretches,
                              const FreeDecayOptions& options) {
  constexpr int kFewestPerUnknown = 3, kMostPasses = 4;
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  if (const auto problems = options.Problems(); !problems.empty()) {
    throw InputError(
        fmt::format("The options of the free decay cannot be used: {}", fmt::join(problems, "; ")));
  }
  FreeDecaySummary summary;
  double sum = 0.0, sum_of_squares = 0.0;
  for (const DecayStretch& stretch : stretches) {
    CHECK_EQ(stretch.time.size(), stretch.motion.size());
    summary.num_samples += static_cast<int>(stretch.time.size());
    if (!stretch.time.empty()) summary.duration += stretch.time.back() - stretch.time.front();
    for (const double value : stretch.motion) {
      sum += value;
      sum_of_squares += value * value;
    }
  }
  const DecayUnknowns unknowns(stretches.size(), options);
  const int fewest = kFewestPerUnknown * unknowns.num_free();
  if (stretches.empty() || summary.num_samples < fewest) {
    summary.message = fmt::format(
        "The decay has only {} samples, expected at least {}.", summary.num_samples, fewest);
    return summary;
  }
  const double scale = std::sqrt(sum_of_squares / summary.num_samples);
  if (!(scale > 0.0) || !std::isfinite(sum)) {
    summary.message = "Nothing decays: the motion is 0 throughout.";
    return summary;
  }

  // From two starts, as the one of least squares may be biased far by noise.
  Eigen::VectorXd start = DecayGuess(stretches, options);
  DecayPoint found = SearchDecay(start, stretches, options, scale, kInfinite);
  start[kLinearRate] = 3.0 * static_cast<double>(stretches.size()) / summary.duration;
  start[kQuadraticRate] = 0.0;
  const DecayPoint other = SearchDecay(start, stretches, options, scale, kInfinite);
  if (!found.solve.converged || (other.solve.converged && other.solve.cost < found.solve.cost)) {
    found = other;
  }
  auto residuals = DecayResidualsAt(found.unknowns, stretches, options.output);
  double sigma = scale;
  for (int pass = 0; pass < kMostPasses && residuals && found.solve.converged; ++pass) {
    const double next = SigmaOf(residuals->residual, scale);
    if (pass > 0 && std::abs(next - sigma) < 0.1 * sigma) break;
    sigma = next;
    found = SearchDecay(found.unknowns, stretches, options, sigma, options.huber_k);
    residuals = DecayResidualsAt(found.unknowns, stretches, options.output);
  }
  if (!residuals || !found.solve.converged) {
    summary.message = found.solve.message;
    return summary;
  }

  for (std::size_t rate = 0; rate < kNumDecayRates; ++rate) {
    summary.rates[rate] = found.unknowns[static_cast<Eigen::Index>(rate)];
  }
  for (const int held : found.solve.held) {
    summary.on_bound[static_cast<std::size_t>(held)] = true;
  }
  summary.covariance = DecayCovariance(
      stretches, *residuals, unknowns.fixed(), options.huber_k * sigma, options.max_noise_order);
  summary.rms = std::sqrt(residuals->residual.squaredNorm() / summary.num_samples);
  summary.residuals = residuals->residual;
  summary.largest_speed = residuals->largest_speed;
  summary.smallest_speed = residuals->smallest_speed;
  const double middle = (summary.largest_speed + summary.smallest_speed) / 2.0;
  if (!Decays(summary, middle)) {
    summary.message =
        "Nothing decays: the damping of this motion cannot be told from 0 at 95 %. Expected a "
        "vehicle that loses its speed with nothing driving it. Take a decay from a higher speed, "
        "or a longer one.";
    return summary;
  }
  summary.usable = true;
  summary.message = fmt::format("free decay over {} samples, {:.1f} s in {} {}.",
                                summary.num_samples,
                                summary.duration,
                                stretches.size(),
                                stretches.size() == 1 ? "stretch" : "stretches");
  AddCaveats(options, &summary);
  return summary;
}

}  // namespace fathom
