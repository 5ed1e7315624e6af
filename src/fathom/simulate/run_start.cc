// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/run_start.h"

#include "fathom/signal/pose_velocity.h"
#include "fathom/simulate/effect_simulation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <Eigen/Dense>
#include <glog/logging.h>

namespace fathom {

double InitialVelocity(const Segment& segment) {
  return std::isfinite(segment.initial_velocity) ? segment.initial_velocity
                                                 : segment.velocity.front();
}

double VelocityBehind(const ExtendedModel& model,
                      const EffectInputs& inputs,
                      double time,
                      double reading) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  // Near the reading, where a run that diverges from afar does not.
  const double probes[] = {reading, reading + 0.1};
  double shown[2];
  const EffectSimulation simulation(&inputs, {time, {time}, {}});
  EffectOutputs outputs;
  for (int k = 0; k < 2; ++k) {
    if (!simulation.Run(model, {probes[k], 0.0}, &outputs)) return kNone;
    shown[k] = outputs.velocity.front();
  }
  const double slope = (shown[1] - shown[0]) / (probes[1] - probes[0]);
  return slope == 0.0 ? kNone : probes[0] + (reading - shown[0]) / slope;
}

std::optional<InitialState> StateBehind(const ExtendedModel& model,
                                        const EffectInputs& inputs,
                                        double start,
                                        const std::vector<double>& time,
                                        const std::vector<double>& readings,
                                        const InitialState& guess) {
  constexpr double kFirstSeconds = 2.0;
  constexpr int kNumSteps = 3;  // it is linear but for the damping
  const auto end = std::lower_bound(time.begin(), time.end(), time.front() + kFirstSeconds);
  const EffectSimulation simulation(&inputs, {start, {time.begin(), end}, {}});
  InitialState state = guess;
  EffectOutputs outputs;
  for (int step = 0; step < kNumSteps; ++step) {
    if (!simulation.RunWithSensitivities(model, state, &outputs)) return std::nullopt;
    const auto n = static_cast<Eigen::Index>(outputs.velocity.size());
    Eigen::MatrixXd columns(n, 2);
    columns.col(0) = outputs.velocity_sensitivity.col(EffectSimulation::kInitialVelocityColumn);
    columns.col(1) = outputs.velocity_sensitivity.col(
        EffectSimulation::NumColumns(model) -
        static_cast<Eigen::Index>(EffectSimulation::ExcessesOf(model).size()));
    const Eigen::VectorXd miss = Eigen::Map<const Eigen::VectorXd>(readings.data(), n) -
                                 Eigen::Map<const Eigen::VectorXd>(outputs.velocity.data(), n);
    const Eigen::Vector2d change = columns.completeOrthogonalDecomposition().solve(miss);
    state.velocity += change[0];
    state.reading_excess += change[1];
  }
  return state;
}

std::optional<InitialState> StartOf(const ExtendedModel& model,
                                    const Segment& segment,
                                    double reading,
                                    double position,
                                    const EffectInputs* inputs) {
  if (model.effects.empty()) return InitialState{reading, position};
  CHECK(inputs != nullptr);
  const double velocity = VelocityBehind(model, *inputs, segment.time.front(), reading);
  if (!std::isfinite(velocity)) return std::nullopt;
  const InitialState start = {velocity, position};
  if (!EffectSimulation::HasReadingMemory(model)) return start;
  return StateBehind(model, *inputs, segment.time.front(), segment.time, segment.velocity, start);
}

double PositionAt(const Log& log, Dof dof, double time) {
  if (!log.pose) return 0.0;
  const Poses poses = PosesOf(*log.pose);
  const std::vector<double> position = DisplacementAlong(dof, poses);
  const auto next = std::lower_bound(poses.time.begin(), poses.time.end(), time);
  if (next == poses.time.begin()) return position.front();
  if (next == poses.time.end()) return position.back();
  const auto i = static_cast<std::size_t>(next - poses.time.begin());
  const double share = (time - poses.time[i - 1]) / (poses.time[i] - poses.time[i - 1]);
  return position[i - 1] + share * (position[i] - position[i - 1]);
}

}  // namespace fathom
