// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/search/joint_search.h"

#include "fathom/joint_refinement/motion/global_columns.h"
#include "fathom/joint_refinement/problem/joint_problem.h"
#include "fathom/joint_refinement/search/process_fit.h"

#include <algorithm>
#include <cmath>

namespace fathom {
namespace {

// The mode over all but processes and setup. False, with the reason in the summary, if it was not
// found.
bool FindMode(const JointOptions& options, JointStart* at, SearchEnd* end, JointSummary* summary) {
  const BoundedSolve solve = SolveJoint(&at->data,
                                        at->processes,
                                        PriorsOf(options, at->unknowns, {}),
                                        {.max_iterations = options.max_iterations},
                                        &at->unknowns);
  if (!(summary->initial_cost > 0.0)) summary->initial_cost = solve.initial_cost;
  summary->num_iterations += solve.num_iterations;
  summary->seconds_per_iteration = solve.seconds_per_iteration;
  summary->final_cost = solve.cost;
  summary->message = solve.message;
  summary->converged = solve.converged;
  end->held_at_zero = solve.held;
  return solve.converged;
}

// The mode with the model held where it is: poses that agree with its motion. A search that does
// not end is no reason to stop, the next one goes on from there.
void FindPoses(const JointOptions& options, JointStart* at) {
  std::vector<GlobalsPrior> priors = PriorsOf(options, at->unknowns, {});
  std::fill_n(priors[0].std.begin(), kModelColumns, 0.0);
  SolveJoint(
      &at->data, at->processes, priors, {.max_iterations = options.max_iterations}, &at->unknowns);
}

bool IsSetupFree(const JointOptions& options) {
  return options.size_scale_std > 0.0 || options.mount_position_std > 0.0 ||
         options.mount_angle_std > 0.0;
}

// The setup, and the mode under it. False as FindMode().
bool MoveSetup(const JointOptions& options, JointStart* at, SearchEnd* end, JointSummary* summary) {
  end->setup = FitMarkerSizeAndMount(
      [&](const JointUnknowns& now) { return PriorsOf(options, now, end->held_at_zero); },
      end->setup,
      &at->data,
      &at->processes,
      &at->unknowns);
  if (!end->setup.converged) {
    summary->converged = false;
    summary->message = end->setup.message;
    return false;
  }
  // It knows nothing of the dampings' bounds.
  return !end->setup.moved || FindMode(options, at, end, summary);
}

// Responses that the processes do not admit are none.
void DropResponses(const ProcessSet& processes, JointUnknowns* unknowns) {
  for (SegmentUnknowns& segment : unknowns->segments) {
    for (int i = 0; i < kNumResponse; ++i) {
      const bool is_mean = i % kResponseTerms == 0;
      if (!is_mean && processes.response_std[i / kResponseTerms] == 0.0) segment.response[i] = 0.0;
    }
  }
}

// Whether two sets of processes have the same wanders and responses, and both a model error or
// none.
bool HaveSameParts(const ProcessSet& a, const ProcessSet& b) {
  for (int j = 0; j < kNumHeld; ++j) {
    if (a.wander[j].IsPresent() != b.wander[j].IsPresent()) return false;
    if ((a.response_std[j] > 0.0) != (b.response_std[j] > 0.0)) return false;
  }
  return (a.model_error > 0.0) == (b.model_error > 0.0);
}

}  // namespace

std::vector<GlobalsPrior> PriorsOf(const JointOptions& options,
                                   const JointUnknowns& unknowns,
                                   const std::vector<int>& held_at_zero) {
  std::vector<GlobalsPrior> priors(unknowns.segments.size());
  for (size_t r = 0; r < priors.size(); ++r) {
    GlobalsPrior& prior = priors[r];
    for (const int i : held_at_zero) prior.std[i] = 0.0;
    if (options.moves_freely) std::fill_n(prior.std.begin(), kModelColumns, 0.0);
    prior.std[kClockColumn] = options.clock_offset_std;
    prior.offset[kClockColumn] = unknowns.segments[r].clock_offset;
    prior.std[kSizeColumn] = options.size_scale_std;
    prior.offset[kSizeColumn] = unknowns.setup.size_scale - 1.0;
    for (int i = 0; i < 6; ++i) {
      prior.std[kMountColumns + i] = i < 3 ? options.mount_position_std : options.mount_angle_std;
      prior.offset[kMountColumns + i] = unknowns.setup.mount[i];
    }
  }
  return priors;
}

bool SearchJoint(const JointOptions& options,
                 JointStart* at,
                 SearchEnd* end,
                 JointSummary* summary) {
  constexpr double kSettled = 0.5;  // of the log-likelihood
  const int excited = at->data.excited;
  std::vector<LinearSegment> linear;
  bool is_setup_found = !IsSetupFree(options);
  if (at->poses == StartPoses::kHeldStill) FindPoses(options, at);
  while (true) {
    if (options.on_round) options.on_round(summary->num_rounds + 1, options.max_rounds);
    if (!Linearise(&at->data, at->unknowns, at->processes.corner_sigma, &linear)) {
      summary->message = "the simulation diverges, or a marker falls behind the camera.";
      return false;
    }
    const auto priors = WithSetupHeld(PriorsOf(options, at->unknowns, end->held_at_zero));
    const bool is_first = summary->num_rounds == 0;
    const double before =
        is_first ? 0.0 : LinearJoint(linear, priors, at->processes, excited).log_likelihood();
    const ProcessFit fit = FitProcesses(linear, priors, at->processes, excited);
    if (!std::isfinite(fit.log_likelihood)) {
      summary->message = "the corners do not determine some unknown.";
      return false;
    }
    const bool has_settled = !is_first && HaveSameParts(fit.processes, at->processes) &&
                             fit.log_likelihood < before + kSettled;
    const bool is_last = summary->num_rounds == options.max_rounds;
    if (has_settled || is_last) {
      end->likelihood_settled = has_settled;
      summary->reached_setup = true;
      if (is_setup_found) return true;
      if (!MoveSetup(options, at, end, summary)) return false;
      is_setup_found = true;
      if (is_last || !end->setup.moved) return true;
      continue;
    }
    end->processes_settled = fit.converged;
    at->processes = fit.processes;
    DropResponses(at->processes, &at->unknowns);
    ++summary->num_rounds;
    if (!FindMode(options, at, end, summary)) return false;
    is_setup_found = !IsSetupFree(options);
  }
}

}  // namespace fathom
