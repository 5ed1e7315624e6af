// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/output_error.h"

#include "fathom/base/input_error.h"
#include "fathom/base/robust_std.h"
#include "fathom/output_error/caveats.h"
#include "fathom/output_error/coarse_segments.h"
#include "fathom/output_error/constrained_optimum.h"
#include "fathom/output_error/initial_guess.h"
#include "fathom/output_error/learned/learned_fit.h"
#include "fathom/output_error/window_layout.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glog/logging.h>

namespace fathom {
namespace {

const std::vector<double>& Measured(const Segment& segment, FittedOutput output) {
  return output == FittedOutput::kVelocity ? segment.velocity : segment.position;
}

// Robust standard deviation of the measurement about the present simulation.
double ResidualSpread(const std::vector<ShootingWindow>& windows, const WindowUnknowns& unknowns) {
  std::vector<double> sizes;
  for (size_t w = 0; w < windows.size(); ++w) {
    for (const double miss :
         WindowMisses(windows[w], ModelIn(windows[w], unknowns), StateOf(unknowns, w))) {
      sizes.push_back(std::abs(miss));
    }
  }
  CHECK(!sizes.empty()) << "The search has converged, so its end can be simulated.";
  return RobustStd(std::move(sizes));
}

double RootMeanSquare(std::span<const Segment> segments, FittedOutput output) {
  double sum = 0.0, mean = 0.0, n = 0.0;
  for (const Segment& segment : segments) {
    for (const double y : Measured(segment, output)) {
      sum += y * y;
      mean += y;
      n += 1.0;
    }
  }
  mean /= n;
  return std::sqrt(std::max(0.0, sum / n - mean * mean));
}

void RequireUsable(std::span<const Segment> segments, const OutputErrorOptions& options) {
  if (const auto problems = options.Problems(); !problems.empty()) {
    throw InputError(
        fmt::format("The options of output error cannot be used: {}", fmt::join(problems, "; ")));
  }
  if (segments.empty()) throw InputError("Output error needs at least one segment of data.");
  size_t num_samples = 0;
  for (const Segment& segment : segments) num_samples += segment.time.size();
  const bool has_short = std::any_of(segments.begin(), segments.end(), [](const Segment& segment) {
    return segment.time.size() < 2;
  });
  const size_t num_unknowns =
      kBuoyancy + options.offsets.Count() + segments.size() * StateSize(options.output);
  if (has_short || num_samples <= num_unknowns) {
    throw InputError(
        fmt::format("Output error has {} samples in {} segments, expected at least two in each and "
                    "more than its "
                    "{} unknowns.",
                    num_samples,
                    segments.size(),
                    num_unknowns));
  }
  if (!options.offsets.IsOneInAll() && options.offsets.offset_of.size() != segments.size()) {
    throw InputError(fmt::format("The options name offsets of {} segments, expected {}.",
                                 options.offsets.offset_of.size(),
                                 segments.size()));
  }
  for (const Segment& segment : segments) {
    if (Measured(segment, options.output).size() != segment.time.size()) {
      throw InputError("Output error was asked to fit the position, but the log has no poses.");
    }
  }
}

InitialGuess GuessFor(std::span<const Segment> segments,
                      const std::vector<Segment>& coarse,
                      const OutputErrorOptions& options) {
  if (options.initial_guess) return {*options.initial_guess, "given"};
  return ChooseInitialGuess(coarse.empty() ? segments : coarse);
}

// The model, and each window's first measurement.
WindowUnknowns UnknownsAt(const UncoupledModel<double>& model,
                          const std::vector<ShootingWindow>& windows,
                          const OutputErrorOptions& options) {
  WindowUnknowns unknowns;
  unknowns.vehicle = BlockOf(model);
  unknowns.offsets.assign(options.offsets.Count(), model.buoyancy);
  for (const ShootingWindow& window : windows) {
    const Segment& segment = *window.segment;
    unknowns.states.push_back({segment.velocity[window.begin],
                               segment.position.empty() ? 0.0 : segment.position[window.begin]});
  }
  return unknowns;
}

// The states at the first stamps of the segments.
std::vector<InitialState> SegmentStates(const WindowUnknowns& unknowns,
                                        const std::vector<ShootingWindow>& windows) {
  std::vector<InitialState> states;
  for (size_t w = 0; w < windows.size(); ++w) {
    if (w > 0 && Continues(windows, w - 1)) continue;
    states.push_back(StateOf(unknowns, w));
  }
  return states;
}

// Where the last pass of a search ended.
struct Found {
  ConstrainedOptimum end;  // its initial_cost: of the first pass; num_iterations: of all
  double sigma = 0.0;      // noise level that the last pass went by
};

// Plain least squares first, but for a start that `is_near` the optimum; then, with the noise level
// known, with the robust loss. Wild samples spoil the first estimate of that level, so it is
// repeated until it settles.
Found SearchFrom(const WindowUnknowns& start,
                 bool is_near,
                 std::span<const Segment> segments,
                 const std::vector<ShootingWindow>& windows,
                 const OutputErrorOptions& options) {
  constexpr int kMostRepetitions = 4;
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const double spread = std::max(RootMeanSquare(segments, options.output), 1e-12);
  const auto noise_at = [&](const WindowUnknowns& unknowns) {
    return std::max(ResidualSpread(windows, unknowns), 1e-9 * spread);
  };
  const bool is_robust = options.huber_k < kNever;
  double sigma = is_near && is_robust ? noise_at(start) : 0.1 * spread;
  ConstrainedOptimum end =
      FindConstrainedOptimum(windows, sigma, is_near ? options.huber_k : kNever, options, start);
  const double initial_cost = end.solve.initial_cost;
  int num_iterations = end.solve.num_iterations;
  for (int i = 0; i < kMostRepetitions && end.solve.converged && is_robust; ++i) {
    const double previous_sigma = sigma;
    sigma = noise_at(end.unknowns);
    const double change = std::abs(sigma - previous_sigma) / previous_sigma;
    if (is_near && change < 0.01) break;
    end = FindConstrainedOptimum(windows, sigma, options.huber_k, options, end.unknowns);
    num_iterations += end.solve.num_iterations;
    if (change < 0.1) break;
  }
  end.solve.initial_cost = initial_cost;
  end.solve.num_iterations = num_iterations;
  return {std::move(end), sigma};
}

// The optimum of the coarse segments, which costs little, as a start for all data in the windows
// `fine`. Nothing if there is none.
std::optional<WindowUnknowns> CoarseOptimum(const UncoupledModel<double>& guess,
                                            const std::vector<Segment>& coarse,
                                            const std::vector<ShootingWindow>& fine,
                                            const OutputErrorOptions& options) {
  if (coarse.empty()) return std::nullopt;
  const std::vector<ShootingWindow> windows = LayOutWindows(coarse, options);
  if (windows.size() != fine.size()) return std::nullopt;
  Found found = SearchFrom(UnknownsAt(guess, windows, options), false, coarse, windows, options);
  if (!found.end.solve.converged) return std::nullopt;
  WindowUnknowns near = std::move(found.end.unknowns);
  for (size_t w = 0; w < windows.size(); ++w) {
    // A coarse window begins a little later, or earlier, than its fine one.
    const double begin = windows[w].segment->time[windows[w].begin];
    const double back = begin - fine[w].segment->time[fine[w].begin];
    auto& [v, x] = near.states[w];
    v -= back * ModelIn(windows[w], near).Acceleration(v, fine[w].segment->command.At(begin));
    x -= back * v;
  }
  return near;
}

// Coarse to fine where that works, else on all data from the guess.
Found Search(const UncoupledModel<double>& guess,
             std::span<const Segment> segments,
             const std::vector<Segment>& coarse,
             const std::vector<ShootingWindow>& windows,
             const OutputErrorOptions& options) {
  if (const auto near = CoarseOptimum(guess, coarse, windows, options)) {
    Found found = SearchFrom(*near, true, segments, windows, options);
    if (found.end.solve.converged) return found;
  }
  return SearchFrom(UnknownsAt(guess, windows, options), false, segments, windows, options);
}

OutputErrorSummary FitPlainly(std::span<const Segment> segments,
                              const OutputErrorOptions& options) {
  const std::vector<Segment> coarse = CoarseSegments(segments);
  const InitialGuess guess = GuessFor(segments, coarse, options);
  const std::vector<ShootingWindow> windows = LayOutWindows(segments, options);
  const auto [end, sigma] = Search(guess.model, segments, coarse, windows, options);
  OutputErrorSummary summary;
  summary.initial_guess = guess.family;
  summary.initial_cost = end.solve.initial_cost;
  summary.num_iterations = end.solve.num_iterations;
  summary.message = end.solve.message;
  summary.converged = end.solve.converged;
  if (!end.solve.converged) return summary;
  summary.final_cost = end.solve.cost;
  summary.model = ModelOf(end.unknowns);
  for (const int index : end.solve.held) summary.on_bound[index] = true;
  summary.initial_states = SegmentStates(end.unknowns, windows);
  for (const double value : end.unknowns.offsets) summary.offsets.push_back({.value = value});
  summary.Take(EvidenceAt(summary.ModelsIn(segments.size(), options.offsets),
                          segments,
                          summary.initial_states,
                          options.output,
                          sigma,
                          options.huber_k,
                          options.offsets));
  DescribeEvidence(segments, options.output, &summary);
  return summary;
}

}  // namespace

OutputErrorSummary FitOutputError(std::span<const Segment> segments,
                                  const OutputErrorOptions& options) {
  RequireUsable(segments, options);
  OutputErrorSummary plain = FitPlainly(segments, options);
  if (options.weighting == Weighting::kPlain) return plain;
  return FitUnderLearnedNoise(segments, options, std::move(plain));
}

FittedOutput OutputOf(std::span<const Segment> segments) {
  const bool has_positions =
      std::none_of(segments.begin(), segments.end(), [](const auto& segment) {
        return segment.position.empty();
      });
  return has_positions ? FittedOutput::kPosition : FittedOutput::kVelocity;
}

}  // namespace fathom
