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
#include <limits>
#include <optional>

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

// Counts the samples; the root mean square of their motion.
double CountedSize(std::span<const DecayStretch> stretches, FreeDecaySummary* summary) {
  double sum_of_squares = 0.0;
  for (const DecayStretch& stretch : stretches) {
    CHECK_EQ(stretch.time.size(), stretch.motion.size());
    summary->num_samples += static_cast<int>(stretch.time.size());
    if (!stretch.time.empty()) summary->duration += stretch.time.back() - stretch.time.front();
    for (const double value : stretch.motion) sum_of_squares += value * value;
  }
  return std::sqrt(sum_of_squares / summary->num_samples);
}

// From two starts, as the one of least squares may be biased far by noise.
DecayPoint LeastSquares(std::span<const DecayStretch> stretches,
                        const FreeDecayOptions& options,
                        double duration,
                        double scale) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  Eigen::VectorXd start = DecayGuess(stretches, options);
  DecayPoint found = SearchDecay(start, stretches, options, scale, kInfinite);
  start[kLinearRate] = 3.0 * static_cast<double>(stretches.size()) / duration;
  start[kQuadraticRate] = 0.0;
  DecayPoint other = SearchDecay(start, stretches, options, scale, kInfinite);
  const bool is_better =
      !found.solve.converged || (other.solve.converged && other.solve.cost < found.solve.cost);
  return is_better ? other : found;
}

// A search that ended, and what it leaves; no residuals where it failed.
struct FoundDecay {
  DecayPoint point;
  std::optional<DecayResiduals> residuals;
  double sigma = 0.0;
};

// By Huber's loss, whose sigma is learned in turns.
FoundDecay FindDecay(std::span<const DecayStretch> stretches,
                     const FreeDecayOptions& options,
                     double duration,
                     double scale) {
  constexpr int kMostPasses = 4;
  FoundDecay found = {LeastSquares(stretches, options, duration, scale), {}, scale};
  for (int pass = 0; pass <= kMostPasses; ++pass) {
    found.residuals = DecayResidualsAt(found.point.unknowns, stretches, options.output);
    if (!found.point.solve.converged) found.residuals.reset();
    if (!found.residuals || pass == kMostPasses) break;
    const double next = SigmaOf(found.residuals->residual, scale);
    if (pass > 0 && std::abs(next - found.sigma) < 0.1 * found.sigma) break;
    found.sigma = next;
    found.point = SearchDecay(found.point.unknowns, stretches, options, next, options.huber_k);
  }
  return found;
}

void FillRates(std::span<const DecayStretch> stretches,
               const FreeDecayOptions& options,
               const FoundDecay& found,
               FreeDecaySummary* summary) {
  for (std::size_t rate = 0; rate < kNumDecayRates; ++rate) {
    summary->rates[rate] = found.point.unknowns[static_cast<Eigen::Index>(rate)];
  }
  for (const int held : found.point.solve.held) {
    summary->on_bound[static_cast<std::size_t>(held)] = true;
  }
  const DecayResiduals& residuals = *found.residuals;
  summary->covariance = DecayCovariance(stretches,
                                        residuals,
                                        DecayUnknowns(stretches.size(), options).fixed(),
                                        options.huber_k * found.sigma,
                                        options.max_noise_order);
  summary->rms = std::sqrt(residuals.residual.squaredNorm() / summary->num_samples);
  summary->residuals = residuals.residual;
  summary->largest_speed = residuals.largest_speed;
  summary->smallest_speed = residuals.smallest_speed;
}

}  // namespace

FreeDecaySummary FitFreeDecay(std::span<const DecayStretch> stretches,
                              const FreeDecayOptions& options) {
  constexpr int kFewestPerUnknown = 3;
  if (const auto problems = options.Problems(); !problems.empty()) {
    throw InputError(
        fmt::format("The options of the free decay cannot be used: {}", fmt::join(problems, "; ")));
  }
  FreeDecaySummary summary;
  const double scale = CountedSize(stretches, &summary);
  const int fewest = kFewestPerUnknown * DecayUnknowns(stretches.size(), options).num_free();
  if (stretches.empty() || summary.num_samples < fewest) {
    summary.message = fmt::format(
        "The decay has only {} samples, expected at least {}.", summary.num_samples, fewest);
    return summary;
  }
  if (!(scale > 0.0) || !std::isfinite(scale)) {
    summary.message = "Nothing decays: the motion is 0 throughout.";
    return summary;
  }
  const FoundDecay found = FindDecay(stretches, options, summary.duration, scale);
  if (!found.residuals) {
    summary.message = found.point.solve.message;
    return summary;
  }
  FillRates(stretches, options, found, &summary);
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
