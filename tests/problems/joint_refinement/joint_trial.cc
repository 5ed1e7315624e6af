// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "joint_trial.h"

#include "fathom/least_squares/least_squares.h"
#include "fathom/output_error/output_error.h"
#include "fathom/signal/signals.h"
#include "fathom/simulate/prediction.h"

#include <chrono>
#include <cmath>
#include <random>
#include <vector>

#include "cramer_rao.h"

namespace fathom {
namespace {

double PublishedLeastSquares(std::vector<Segment> segments, double truth) {
  for (Segment& segment : segments) {
    segment.smoothed_velocity = segment.velocity;
    segment.smoothed_square.clear();
    for (size_t i = 0; i < segment.time.size(); ++i) {
      segment.smoothed_force[i] = segment.command.At(segment.time[i]);
    }
  }
  const auto fit = FitLeastSquares(segments);
  return fit.IsUsable() ? fit.model.inertia / truth - 1.0 : JointTrial::kNone;
}

// NMAE of the free run from the first velocity v0 against the true velocity.
double TrueNmae(const UncoupledModel<double>& model, const SyntheticCameraRun& run, double v0) {
  Segment segment;
  segment.time = run.input.segments[0].time;
  segment.velocity = run.true_velocity;
  segment.command = run.input.segments[0].command;
  const auto v = Predict({model}, segment, {v0});
  if (!v) return JointTrial::kNone;
  FigureSums sums;
  sums.Add(segment.time, segment.velocity, *v);
  return sums.Figures().nmae;
}

// Of output error on a velocity sensor of 1 cm/s beside the camera.
double SensorNmae(const CameraExperiment& experiment, const SyntheticCameraRun& run) {
  Segment sensor;
  sensor.time = run.input.segments[0].time;
  sensor.command = run.input.segments[0].command;
  std::mt19937 generator(experiment.seed);
  std::normal_distribution<double> normal;
  for (const double v : run.true_velocity) sensor.velocity.push_back(v + 0.01 * normal(generator));
  OutputErrorOptions from_truth;
  from_truth.initial_guess = run.truth;
  const std::vector<Segment> sensors = {sensor};
  const auto fit = FitOutputError(sensors, from_truth);
  if (!fit.IsUsable()) return JointTrial::kNone;
  return TrueNmae(fit.model, run, fit.initial_states[0].velocity);
}

void ComparePoses(const SyntheticCameraRun& run, const RefinedSegment& refined, JointTrial* trial) {
  double position = 0.0, pnp_position = 0.0, attitude = 0.0, pnp_attitude = 0.0;
  for (size_t k = 0; k < run.true_world_from_body.size(); ++k) {
    const Pose& truth = run.true_world_from_body[k];
    const Pose& pnp = run.input.segments[0].world_from_body[k];
    const Pose& own = refined.world_from_body[k];
    position += (own.translation - truth.translation).squaredNorm();
    pnp_position += (pnp.translation - truth.translation).squaredNorm();
    attitude += std::pow(own.rotation.angularDistance(truth.rotation), 2);
    pnp_attitude += std::pow(pnp.rotation.angularDistance(truth.rotation), 2);
  }
  trial->position = std::sqrt(position / pnp_position);
  trial->attitude = std::sqrt(attitude / pnp_attitude);
}

}  // namespace

JointTrial RunJointTrial(const CameraExperiment& experiment) {
  JointTrial trial;
  const SyntheticCameraRun run = Synthesize(experiment);
  const double truth = run.truth.inertia;
  const Signals signals = SignalsOf(PoseLog(run), experiment.dof, {.source = Source::kCamera});
  trial.published_least_squares = PublishedLeastSquares(signals.train, truth);
  const auto least_squares = FitLeastSquares(signals.train);
  if (least_squares.IsUsable()) trial.least_squares = least_squares.model.inertia / truth - 1.0;
  const auto output_error =
      FitOutputError(signals.train, {.initial_guess = {}, .output = FittedOutput::kPosition});
  if (output_error.IsUsable()) trial.output_error = output_error.model.inertia / truth - 1.0;
  trial.sensor_nmae = SensorNmae(experiment, run);

  const auto begin = std::chrono::steady_clock::now();
  const JointSummary joint = FitJoint(run.input);
  trial.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (!joint.IsUsable()) return trial;
  trial.is_usable = least_squares.IsUsable() && output_error.IsUsable();
  trial.joint = joint.model.inertia / truth - 1.0;
  const ParameterVector error = ToVector(joint.model) - ToVector(run.truth);
  for (int i = 0; i < kNumParameters; ++i) {
    trial.over_std[i] = error[i] / std::sqrt(joint.covariance(i, i));
  }
  const bool has_bound =
      experiment.wander == WanderKind::kFiltered || experiment.wander == WanderKind::kNone;
  if (has_bound && experiment.pitch_per_acceleration == 0.0) {
    const ParameterVector bound = CramerRaoStd(experiment, run);
    for (int i = 0; i < kNumParameters; ++i) trial.over_bound[i] = error[i] / bound[i];
  }
  trial.nmae = TrueNmae(joint.model, run, joint.segments[0].start.velocity);
  ComparePoses(run, joint.segments[0], &trial);
  return trial;
}

}  // namespace fathom
