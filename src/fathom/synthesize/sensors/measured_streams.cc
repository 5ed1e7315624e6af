// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/sensors/measured_streams.h"

#include "fathom/synthesize/experiment/resolution.h"
#include "fathom/synthesize/sensors/noisy_streams.h"
#include "fathom/synthesize/sensors/shown_velocity.h"

#include <cstddef>
#include <vector>

#include <Eigen/Geometry>

namespace fathom {
namespace {

// How much later than the truth the poses are stamped [s].
double PoseDelay(const VehicleMotion& motion) {
  double delay = 0.0;
  for (const Dof dof : kAllDofs) delay += motion.hidden(dof).PoseDelay();
  return delay;
}

// What the poses show of where the vehicle is, along and about each driven DOF.
MotionState ShownPose(const VehicleMotion& motion,
                      MotionState state,
                      const HeldForces& held,
                      double t,
                      const std::vector<Drive>& drives) {
  const Surroundings now = {t, state.velocity, held.sent};
  for (const Drive& drive : drives) {
    const HiddenEffects& hidden = motion.hidden(drive.dof);
    const auto shown = [&](double displacement) {
      return hidden.Displacement(displacement, InstantsOf(hidden, now));
    };
    const int i = Index(drive.dof);
    if (!IsAngular(drive.dof)) {
      state.body_in_world[i] = shown(state.body_in_world[i]);
      continue;
    }
    const double turn = shown(state.travel[i]) - state.travel[i];
    if (turn == 0.0) continue;
    const Eigen::Map<Eigen::Quaterniond> world_from_body(state.world_from_body.data());
    const Eigen::Quaterniond turned(Eigen::Quaterniond(world_from_body) *
                                    Eigen::AngleAxisd(turn, Eigen::Vector3d::Unit(i - 3)));
    state.world_from_body = turned.coeffs();
  }
  return state;
}

}  // namespace

Stream CommandStream(const TrueRun& truth, const Experiment& experiment) {
  Stream stream;
  for (const Drive& drive : experiment.drives) {
    stream.columns.emplace_back(ForceColumn(drive.dof));
    std::vector<double>& column = stream.values.emplace_back();
    for (const auto& command : truth.command) column.push_back(command[Index(drive.dof)]);
  }
  for (const double stamp : truth.command_time) {
    stream.time.push_back(RoundTo(experiment.start_time + stamp, kStampResolution));
  }
  return stream;
}

Stream VelocityStream(const VehicleMotion& motion,
                      const TrueRun& truth,
                      const Experiment& experiment,
                      std::uint64_t seed,
                      Log& log) {
  std::vector<Dof> dofs = experiment.velocity->dofs;
  if (dofs.empty()) {
    for (const Drive& drive : experiment.drives) dofs.push_back(drive.dof);
  }
  ShownVelocity shown(motion, truth);
  return NoisyVelocities(
      dofs, [&](std::size_t, double t) { return shown.At(t); }, experiment, seed, log);
}

Stream PoseStream(const VehicleMotion& motion,
                  const TrueRun& truth,
                  const Experiment& experiment,
                  std::uint64_t seed,
                  Log& log) {
  std::size_t before = 0;
  const auto shown = [&](std::size_t, double t) -> ShownPlace {
    before = truth.Before(t, before);
    const MotionState state = ShownPose(
        motion, truth.StateAt(motion, before, t), truth.held[before], t, experiment.drives);
    return {state.body_in_world, state.world_from_body};
  };
  return NoisyPoses(shown, PoseDelay(motion), experiment, seed, log);
}

}  // namespace fathom
