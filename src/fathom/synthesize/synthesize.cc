// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/synthesize.h"

#include "fathom/base/input_error.h"
#include "fathom/base/random_stream.h"
#include "fathom/synthesize/motion/coupled_truth.h"
#include "fathom/synthesize/motion/true_run.h"
#include "fathom/synthesize/motion/vehicle_motion.h"
#include "fathom/synthesize/sensors/coupled_streams.h"
#include "fathom/synthesize/sensors/measured_streams.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <glog/logging.h>

namespace fathom {
namespace {

// A controller acts along one body axis on one world coordinate: they must stay the same line.
void RequireAxesThatStay(const Experiment& experiment) {
  for (const Drive& controlled : experiment.drives) {
    if (!controlled.pid) continue;
    for (const Drive& other : experiment.drives) {
      const bool is_turned = IsAngular(other.dof) && other.dof != controlled.dof &&
                             Index(other.dof) != Index(controlled.dof) + 3;
      if (!is_turned) continue;
      throw InputError(
          fmt::format("experiment '{}': {} is in closed loop while {} turns its axis, expected "
                      "{} in open loop or no {}.",
                      experiment.name,
                      Name(controlled.dof),
                      Name(other.dof),
                      Name(controlled.dof),
                      Name(other.dof)));
    }
  }
}

// Thrusters, fins and shafts act on several DOFs at once.
void RequireForcesAlone(const Vehicle& vehicle, const Experiment& experiment) {
  if (experiment.thrusters.empty() && experiment.fins.empty() && experiment.shafts.empty()) return;
  throw InputError(
      fmt::format("vehicle '{}': has no coupled_model, expected one since experiment '{}' drives "
                  "thrusters, fins or shafts. Drive DOFs instead, as surge: {{...}}.",
                  vehicle.name,
                  experiment.name));
}

// A current flows past in the world.
void RequireStillWater(const Vehicle& vehicle, const Experiment& experiment) {
  if (experiment.current.isZero(0.0)) return;
  throw InputError(
      fmt::format("vehicle '{}': has no coupled_model, expected one since experiment '{}' has a "
                  "current. Hide steady_current in single DOFs instead.",
                  vehicle.name,
                  experiment.name));
}

// What is hidden is hidden in one DOF.
void RequireNoEffects(const Vehicle& vehicle, std::span<const ActiveEffect> effects) {
  if (effects.empty()) return;
  throw InputError(
      fmt::format("vehicle '{}': has a coupled_model, in which no effect can be hidden, expected "
                  "`models` of single DOFs to hide {} in.",
                  vehicle.name,
                  effects.front().effect->info().name));
}

std::vector<Dof> DrivenDofs(const Vehicle& vehicle, const Experiment& experiment) {
  RequireForcesAlone(vehicle, experiment);
  RequireStillWater(vehicle, experiment);
  std::vector<Dof> dofs;
  for (const Drive& drive : experiment.drives) {
    if (!vehicle.models[Index(drive.dof)]) {
      throw InputError(
          fmt::format("vehicle '{}': has no model of {}, expected one since experiment '{}' drives "
                      "it. Add models: {}: {{...}} to the vehicle file.",
                      vehicle.name,
                      Name(drive.dof),
                      experiment.name,
                      Name(drive.dof)));
    }
    dofs.push_back(drive.dof);
  }
  return dofs;
}

void RequireTraces(const Experiment& experiment, std::span<const ActiveEffect> effects) {
  for (const ActiveEffect& active : effects) {
    const bool is_driven =
        std::any_of(experiment.drives.begin(), experiment.drives.end(), [&](const Drive& drive) {
          return drive.dof == active.setting.dof;
        });
    if (!is_driven) {
      throw InputError(
          fmt::format("experiment '{}': does not drive {}, expected it to since {} is "
                      "to be hidden there.",
                      experiment.name,
                      Name(active.setting.dof),
                      active.effect->info().name));
    }
    if (active.effect->info().needs_pose && !(experiment.pose && experiment.pose->is_logged)) {
      throw InputError(
          fmt::format("experiment '{}': logs no pose, expected one since {} shows in "
                      "nothing else.",
                      experiment.name,
                      active.effect->info().name));
    }
  }
}

std::array<Turbulence, 6> TurbulenceOf(const Experiment& experiment,
                                       std::span<const ActiveEffect> effects,
                                       std::uint64_t seed) {
  std::array<Turbulence, 6> turbulence;
  for (const Drive& drive : experiment.drives) {
    // To the last command, see LastCommand().
    const double ahead = std::max(0.0, -HiddenIn(drive.dof, effects).Delay());
    turbulence[Index(drive.dof)] =
        Turbulence(drive.turbulence,
                   experiment.duration + ahead,
                   RandomStream(seed, "turbulence." + std::string(Name(drive.dof))));
  }
  return turbulence;
}

void RequireUsable(const Stream& stream, const char* file, const Experiment& experiment) {
  if (stream.time.size() < 2) {
    throw InputError(
        fmt::format("experiment '{}': {} would hold {} rows, expected at least 2. Make it longer, "
                    "its rates higher or its drop-outs fewer.",
                    experiment.name,
                    file,
                    stream.time.size()));
  }
  for (const auto& column : stream.values) {
    if (std::all_of(column.begin(), column.end(), [](double x) { return std::isfinite(x); }))
      continue;
    throw InputError(fmt::format(
        "experiment '{}': {} would hold numbers that are not finite. Check the units of "
        "its inputs.",
        experiment.name,
        file));
  }
}

// What an experiment says of its log.
Log EmptyLog(const Vehicle& vehicle, const Experiment& experiment) {
  Log log;
  log.name = experiment.name;
  log.vehicle = vehicle.name;
  log.notes = experiment.notes;
  log.held_out = experiment.held_out;
  return log;
}

Log SynthesizeCoupled(const Vehicle& vehicle, const Experiment& experiment, std::uint64_t seed) {
  Log log = EmptyLog(vehicle, experiment);
  log.dofs = vehicle.coupled->dofs;
  const CoupledTruth truth = DriveCoupled(vehicle, experiment, seed);
  AddCoupledCommand(truth, vehicle, experiment, &log);
  RequireUsable(log.command ? *log.command
                : log.fins  ? *log.fins
                            : *log.shafts,
                "command.csv",
                experiment);
  if (experiment.velocity) {
    log.velocity = CoupledVelocityStream(truth, experiment, seed, log);
    RequireUsable(*log.velocity, "velocity.csv", experiment);
  }
  if (experiment.pose && experiment.pose->is_logged) {
    log.pose = CoupledPoseStream(truth, experiment, seed, log);
    RequireUsable(*log.pose, "pose.csv", experiment);
  }
  return log;
}

}  // namespace

Log Synthesize(const Vehicle& vehicle, const Experiment& experiment, std::uint64_t seed) {
  return Synthesize(vehicle, experiment, {}, seed);
}

Log Synthesize(const Vehicle& vehicle,
               const Experiment& experiment,
               std::span<const ActiveEffect> effects,
               std::uint64_t seed) {
  CHECK_GT(experiment.duration, 0.0);
  CHECK_GT(experiment.command_rate, 0.0);
  CHECK(!experiment.drives.empty() || !experiment.thrusters.empty() || !experiment.fins.empty() ||
        !experiment.shafts.empty());
  if (vehicle.coupled) {
    RequireNoEffects(vehicle, effects);
    return SynthesizeCoupled(vehicle, experiment, seed);
  }
  RequireAxesThatStay(experiment);
  RequireTraces(experiment, effects);
  Log log = EmptyLog(vehicle, experiment);
  log.dofs = DrivenDofs(vehicle, experiment);

  const VehicleMotion motion(vehicle, log.dofs, effects, TurbulenceOf(experiment, effects, seed));
  const TrueRun truth = DriveThrough(motion, experiment, seed);
  log.command = CommandStream(truth, experiment);
  RequireUsable(*log.command, "command.csv", experiment);
  if (experiment.velocity) {
    log.velocity = VelocityStream(motion, truth, experiment, seed, log);
    RequireUsable(*log.velocity, "velocity.csv", experiment);
  }
  if (experiment.pose && experiment.pose->is_logged) {
    log.pose = PoseStream(motion, truth, experiment, seed, log);
    RequireUsable(*log.pose, "pose.csv", experiment);
  }
  return log;
}

Stream ShownPoses(const Vehicle& vehicle,
                  const Experiment& experiment,
                  std::span<const ActiveEffect> effects,
                  std::uint64_t seed,
                  const Sampling& sampling) {
  // The controllers see the experiment's own sensor; only then is it another one.
  Experiment seen_by_camera = experiment;
  seen_by_camera.pose = PoseSensor{.sampling = sampling};
  Log remarks;
  if (vehicle.coupled) {
    RequireNoEffects(vehicle, effects);
    return CoupledPoseStream(
        DriveCoupled(vehicle, experiment, seed), seen_by_camera, seed, remarks);
  }
  RequireAxesThatStay(experiment);
  const VehicleMotion motion(
      vehicle, DrivenDofs(vehicle, experiment), effects, TurbulenceOf(experiment, effects, seed));
  const TrueRun truth = DriveThrough(motion, experiment, seed);
  return PoseStream(motion, truth, seen_by_camera, seed, remarks);
}

std::array<Scales, 6> ScalesOf(const Vehicle& vehicle,
                               const Experiment& experiment,
                               std::uint64_t seed) {
  RequireAxesThatStay(experiment);
  const VehicleMotion motion(vehicle, DrivenDofs(vehicle, experiment));
  const TrueRun truth = DriveThrough(motion, experiment, seed);
  std::array<Scales, 6> scales;
  const double n = static_cast<double>(truth.time.size());
  for (const Drive& drive : experiment.drives) {
    const int i = Index(drive.dof);
    Scales& scale = scales[i];
    double force2 = 0.0, speed2 = 0.0, travel = 0.0, travel2 = 0.0, change = 0.0;
    for (std::size_t k = 0; k < truth.time.size(); ++k) {
      const double force = truth.command[k][i];
      force2 += force * force;
      scale.peak_force = std::max(scale.peak_force, std::abs(force));
      if (k > 0) change += std::abs(force - truth.command[k - 1][i]);
      speed2 += truth.states[k].velocity[i] * truth.states[k].velocity[i];
      travel += truth.states[k].travel[i];
      travel2 += truth.states[k].travel[i] * truth.states[k].travel[i];
    }
    scale.force = std::sqrt(force2 / n);
    scale.force_rate = change / experiment.duration;
    scale.speed = std::sqrt(speed2 / n);
    scale.place = travel / n;
    scale.length = std::sqrt(std::max(0.0, travel2 / n - scale.place * scale.place));
    scale.duration = experiment.duration;
  }
  return scales;
}

}  // namespace fathom
