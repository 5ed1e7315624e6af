// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/fit/robust_start.h"

#include "fathom/diagnosis/fit/momentum_balance.h"
#include "fathom/output_error/output_error.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace fathom {

std::optional<RobustStart> FindRobustStart(std::span<const MeasuredSegment> segments) {
  std::vector<Segment> plain_segments;
  bool has_velocity = false;
  for (const MeasuredSegment& segment : segments) {
    plain_segments.push_back(PlainSegment(segment));
    has_velocity = has_velocity || !segment.velocity.empty();
  }
  OutputErrorOptions options;
  const auto guess = MomentumBalance(segments).Fit();
  if (!guess) return std::nullopt;  // no force ever acted
  options.initial_guess = guess->model.baseline;
  options.output = has_velocity ? FittedOutput::kVelocity : FittedOutput::kPosition;
  OutputErrorSummary summary = FitOutputError(plain_segments, options);
  if (!summary.converged) {
    options.initial_guess.reset();
    summary = FitOutputError(plain_segments, options);
  }
  if (!summary.converged) return std::nullopt;
  RobustStart start = {{summary.model, {}}, {}, summary.covariance};
  for (size_t r = 0; r < segments.size(); ++r) {
    InitialState state = segments[r].initial;
    state.velocity = summary.initial_states[r].velocity;
    if (!has_velocity) state.position = summary.initial_states[r].position;
    start.initial.push_back(state);
  }
  return start;
}

}  // namespace fathom
