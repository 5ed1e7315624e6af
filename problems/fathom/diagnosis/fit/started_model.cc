// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/fit/started_model.h"

#include "fathom/diagnosis/fit/momentum_balance.h"
#include "fathom/diagnosis/fit/normal_equations.h"
#include "fathom/diagnosis/fit/residual_noise.h"
#include "fathom/diagnosis/fit/unknowns.h"
#include "fathom/output_error/output_error.h"
#include "fathom/solve/decompositions.h"

#include <utility>

#include <Eigen/Core>

namespace fathom {
namespace {

constexpr int kNumSteps = 3;

}  // namespace

StartedModel StartedFrom(const StructureFit& fit) {
  return {fit.model, fit.covariance, fit.initial, fit.residual};
}

std::optional<StartedModel> FindRobustStart(std::span<const MeasuredSegment> segments) {
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
  StartedModel start = {{summary.model, {}}, summary.covariance, {}, {}};
  for (size_t r = 0; r < segments.size(); ++r) {
    InitialState state = segments[r].initial;
    state.velocity = summary.initial_states[r].velocity;
    if (!has_velocity) state.position = summary.initial_states[r].position;
    start.initial.push_back(state);
  }
  return start;
}

std::optional<StartedModel> UsersModel(const TrainingData& data, StartedModel users) {
  auto at = data.Linearise(users.model, users.initial);
  if (!at) return std::nullopt;
  users.residual = data.measured() - at->simulated;
  const Eigen::Index num_parameters = EffectSimulation::NumParameters(users.model);
  for (int step = 0; step < kNumSteps; ++step) {
    const Whitener white(WhiteNoise(data, users.residual), data.samples());
    const Normal normal = NormalOf(
        white, at->jacobian.rightCols(at->jacobian.cols() - num_parameters), users.residual);
    Unknowns unknowns = Pack(data, users.model, users.initial);
    unknowns.value.tail(normal.g.size()) += SolveSymmetric(normal.A, normal.g);
    Unpack(data, unknowns.value, &users.model, &users.initial);
    at = data.Linearise(users.model, users.initial);
    if (!at) return std::nullopt;
    users.residual = data.measured() - at->simulated;
  }
  return users;
}

}  // namespace fathom
