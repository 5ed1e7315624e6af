// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/synthesize.h"

#include "fathom/base/input_error.h"
#include "fathom/simulate/random_stream.h"
#include "fathom/simulate/resolution.h"
#include "fathom/simulate/sampling.h"
#include "fathom/simulate/shown_velocity.h"
#include "fathom/simulate/true_run.h"
#include "fathom/simulate/vehicle_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <glog/logging.h>

namespace fathom {
namespace {

constexpr double kStampResolution = 1e-6;  // [s]

std::string Purpose(const char* what, Dof dof) { return fmt::format("{}.{}", what, Name(dof)); }

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

std::vector<Dof> DrivenDofs(const Vehicle& vehicle, const Experiment& experiment) {
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
    const double ahead = std::max(0.0, -EffectChain(drive.dof, effects).Delay());
    turbulence[Index(drive.dof)] = Turbulence(drive.turbulence,
                                              experiment.duration + ahead,
                                              RandomStream(seed, Purpose("turbulence", drive.dof)));
  }
  return turbulence;
}

// How much later than the truth the poses are stamped [s].
double PoseDelay(std::span<const ActiveEffect> effects) {
  double delay = 0.0;
  for (const ActiveEffect& active : effects) {
    if (!active.effect->laws().has.pose_delay) continue;
    delay += active.effect->laws().In<double>().PoseDelay(active.values.data());
  }
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
    const EffectChain& chain = motion.chain(drive.dof);
    const int i = Index(drive.dof);
    if (!IsAngular(drive.dof)) {
      state.body_in_world[i] = chain.Displacement(state.body_in_world[i], now);
      continue;
    }
    const double turn = chain.Displacement(state.travel[i], now) - state.travel[i];
    if (turn == 0.0) continue;
    const Eigen::Map<Eigen::Quaterniond> world_from_body(state.world_from_body.data());
    const Eigen::Quaterniond shown(Eigen::Quaterniond(world_from_body) *
                                   Eigen::AngleAxisd(turn, Eigen::Vector3d::Unit(i - 3)));
    state.world_from_body = shown.coeffs();
  }
  return state;
}

void AddRow(Stream& stream, double stamp, const std::vector<double>& row) {
  stream.time.push_back(stamp);
  for (std::size_t column = 0; column < row.size(); ++column) {
    stream.values[column].push_back(row[column]);
  }
}

void RemarkOnDropOuts(const SampleTimes& samples, const char* file, Log& log) {
  if (samples.num_drop_outs == 0) return;
  log.remarks.push_back(fmt::format("{}: {} drop-outs took {} of {} samples.",
                                    file,
                                    samples.num_drop_outs,
                                    samples.num_lost,
                                    samples.time.size()));
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

Stream CommandStream(const TrueRun& truth, const Experiment& experiment) {
  Stream stream;
  for (const Drive& drive : experiment.drives) stream.columns.emplace_back(ForceColumn(drive.dof));
  stream.values.resize(stream.columns.size());
  for (std::size_t k = 0; k < truth.command_time.size(); ++k) {
    std::vector<double> row;
    for (const Drive& drive : experiment.drives) row.push_back(truth.command[k][Index(drive.dof)]);
    AddRow(stream, RoundTo(experiment.start_time + truth.command_time[k], kStampResolution), row);
  }
  return stream;
}

Stream VelocityStream(const VehicleMotion& motion,
                      const TrueRun& truth,
                      const Experiment& experiment,
                      std::uint64_t seed,
                      Log& log) {
  const VelocitySensor& sensor = *experiment.velocity;
  const SampleTimes samples =
      DrawSampleTimes(sensor.sampling, experiment.duration, seed, "velocity");
  RemarkOnDropOuts(samples, "velocity.csv", log);
  Stream stream;
  std::vector<CorrelatedNoise> noise;
  for (const Drive& drive : experiment.drives) {
    stream.columns.emplace_back(VelocityColumn(drive.dof));
    noise.emplace_back(RandomStream(seed, Purpose("velocity.noise", drive.dof)),
                       sensor.noise_correlation);
  }
  stream.values.resize(stream.columns.size());
  ShownVelocity shown(motion, truth);
  for (std::size_t k = 0; k < samples.time.size(); ++k) {
    const double t = samples.time[k];
    const std::array<double, 6> velocity = shown.At(t);
    std::vector<double> row;  // of lost samples too: noise goes on underneath
    for (std::size_t i = 0; i < experiment.drives.size(); ++i) {
      const int dof = Index(experiment.drives[i].dof);
      const double measured = velocity[dof] + sensor.noise[dof] * noise[i].Next();
      row.push_back(RoundTo(measured, sensor.resolution));
    }
    if (!samples.has_arrived[k]) continue;
    AddRow(stream, RoundTo(experiment.start_time + t, kStampResolution), row);
  }
  return stream;
}

Stream PoseStream(const VehicleMotion& motion,
                  const TrueRun& truth,
                  const Experiment& experiment,
                  double delay,
                  std::uint64_t seed,
                  Log& log) {
  const PoseSensor& sensor = *experiment.pose;
  const SampleTimes samples = DrawSampleTimes(sensor.sampling, experiment.duration, seed, "pose");
  RemarkOnDropOuts(samples, "pose.csv", log);
  RandomStream position_noise(seed, "pose.noise.position");
  RandomStream angle_noise(seed, "pose.noise.angle");
  const auto normal3 = [](RandomStream& random, double sigma) {
    Eigen::Vector3d vector;
    for (double& number : vector) number = sigma * random.Normal();
    return vector;
  };
  Stream stream;
  stream.columns = {"x", "y", "z", "qx", "qy", "qz", "qw"};
  stream.values.resize(stream.columns.size());
  std::size_t place = 0;
  for (std::size_t k = 0; k < samples.time.size(); ++k) {
    const double t = samples.time[k];
    place = truth.Before(t, place);
    const MotionState state =
        ShownPose(motion, truth.StateAt(motion, place, t), truth.held[place], t, experiment.drives);
    const Eigen::Vector3d p = state.body_in_world + normal3(position_noise, sensor.position_noise);
    const Eigen::Vector3d turn = normal3(angle_noise, sensor.angle_noise);
    const double angle = turn.norm();
    const Eigen::Quaterniond body_from_measured(Eigen::AngleAxisd(
        angle, angle > 0.0 ? Eigen::Vector3d(turn / angle) : Eigen::Vector3d::UnitX()));
    const Eigen::Quaterniond q = Eigen::Quaterniond(state.world_from_body) * body_from_measured;
    if (!samples.has_arrived[k]) continue;
    std::vector<double> row = {p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()};
    for (double& number : row) number = RoundTo(number, sensor.resolution);
    AddRow(stream, RoundTo(experiment.start_time + t + delay, kStampResolution), row);
  }
  return stream;
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
  CHECK(!experiment.drives.empty());
  RequireAxesThatStay(experiment);
  RequireTraces(experiment, effects);
  Log log;
  log.name = experiment.name;
  log.dofs = DrivenDofs(vehicle, experiment);
  log.vehicle = vehicle.name;
  log.notes = experiment.notes;
  log.held_out = experiment.held_out;

  const VehicleMotion motion(vehicle, log.dofs, effects, TurbulenceOf(experiment, effects, seed));
  const TrueRun truth = DriveThrough(motion, experiment, seed);
  log.command = CommandStream(truth, experiment);
  RequireUsable(*log.command, "command.csv", experiment);
  if (experiment.velocity) {
    log.velocity = VelocityStream(motion, truth, experiment, seed, log);
    RequireUsable(*log.velocity, "velocity.csv", experiment);
  }
  if (experiment.pose && experiment.pose->is_logged) {
    log.pose = PoseStream(motion, truth, experiment, PoseDelay(effects), seed, log);
    RequireUsable(*log.pose, "pose.csv", experiment);
  }
  return log;
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
    double force2 = 0.0, speed2 = 0.0, travel = 0.0, travel2 = 0.0;
    for (std::size_t k = 0; k < truth.time.size(); ++k) {
      force2 += truth.command[k][i] * truth.command[k][i];
      speed2 += truth.states[k].velocity[i] * truth.states[k].velocity[i];
      travel += truth.states[k].travel[i];
      travel2 += truth.states[k].travel[i] * truth.states[k].travel[i];
    }
    const double spread2 = std::max(0.0, travel2 / n - travel * travel / (n * n));
    scales[i] = {
        std::sqrt(force2 / n), std::sqrt(speed2 / n), std::sqrt(spread2), experiment.duration};
  }
  return scales;
}

}  // namespace fathom
