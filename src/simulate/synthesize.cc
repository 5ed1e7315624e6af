// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/synthesize.h"

#include "fathom/base/input_error.h"
#include "fathom/simulate/pid.h"
#include "fathom/simulate/random_stream.h"
#include "fathom/simulate/resolution.h"
#include "fathom/simulate/sampling.h"
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

// The command of one DOF, from stamp to stamp.
class Driver {
 public:
  Driver(const Experiment& experiment, const Drive& drive, std::uint64_t seed)
      : dof_(drive.dof),
        input_(drive.input),
        resolution_(experiment.command_resolution),
        measurement_(seed, Purpose("control", drive.dof)) {
    RandomStream random(seed, Purpose("input", drive.dof));
    DrawRandomParts(input_, random);
    if (drive.pid) pid_.emplace(*drive.pid, 1.0 / experiment.command_rate);
    if (experiment.pose) {
      noise_ = IsAngular(dof_) ? experiment.pose->angle_noise : experiment.pose->position_noise;
    }
  }

  double Force(double t, const MotionState& state) {
    const double value = Value(input_, t);
    if (!pid_) return RoundTo(value, resolution_);
    const double measured = state.travel[Index(dof_)] + noise_ * measurement_.Normal();
    return RoundTo(pid_->Force(value, measured), resolution_);
  }

 private:
  Dof dof_;
  InputSignal input_;
  double resolution_;
  double noise_ = 0.0;
  RandomStream measurement_;
  std::optional<Pid> pid_;
};

// The vehicle's state at each command stamp and the forces held from there on.
struct Truth {
  std::vector<double> time;  // since the start [s]
  std::vector<MotionState> states;
  std::vector<std::array<double, 6>> forces;
};

Truth Run(const VehicleMotion& motion, const Experiment& experiment, std::uint64_t seed) {
  std::vector<Driver> drivers;
  MotionState state;
  for (const Drive& drive : experiment.drives) {
    drivers.emplace_back(experiment, drive, seed);
    state.velocity[Index(drive.dof)] = drive.initial_speed;
  }
  Truth truth;
  for (int k = 0; k / experiment.command_rate < experiment.duration; ++k) {
    const double t = RoundTo(k / experiment.command_rate, kStampResolution);
    if (k > 0) state = motion.After(state, truth.forces.back(), t - truth.time.back());
    std::array<double, 6> force{};
    for (std::size_t i = 0; i < drivers.size(); ++i) {
      force[Index(experiment.drives[i].dof)] = drivers[i].Force(t, state);
    }
    truth.time.push_back(t);
    truth.states.push_back(state);
    truth.forces.push_back(force);
  }
  return truth;
}

// Calls take(t, state) at each sample, in order; lost ones too, so that noise goes on underneath.
template <typename Take>
void Measure(const VehicleMotion& motion,
             const Truth& truth,
             const SampleTimes& samples,
             const Take& take) {
  std::size_t k = 0;
  for (std::size_t i = 0; i < samples.time.size(); ++i) {
    const double t = samples.time[i];
    while (k + 1 < truth.time.size() && truth.time[k + 1] <= t) ++k;
    take(t,
         motion.After(truth.states[k], truth.forces[k], t - truth.time[k]),
         samples.has_arrived[i]);
  }
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

Stream CommandStream(const Truth& truth, const Experiment& experiment) {
  Stream stream;
  for (const Drive& drive : experiment.drives) stream.columns.emplace_back(ForceColumn(drive.dof));
  stream.values.resize(stream.columns.size());
  for (std::size_t k = 0; k < truth.time.size(); ++k) {
    std::vector<double> row;
    for (const Drive& drive : experiment.drives) row.push_back(truth.forces[k][Index(drive.dof)]);
    AddRow(stream, RoundTo(experiment.start_time + truth.time[k], kStampResolution), row);
  }
  return stream;
}

Stream VelocityStream(const VehicleMotion& motion,
                      const Truth& truth,
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
  Measure(motion, truth, samples, [&](double t, const MotionState& state, bool has_arrived) {
    std::vector<double> row;
    for (std::size_t i = 0; i < experiment.drives.size(); ++i) {
      const int dof = Index(experiment.drives[i].dof);
      const double measured = state.velocity[dof] + sensor.noise[dof] * noise[i].Next();
      row.push_back(RoundTo(measured, sensor.resolution));
    }
    if (has_arrived) AddRow(stream, RoundTo(experiment.start_time + t, kStampResolution), row);
  });
  return stream;
}

Stream PoseStream(const VehicleMotion& motion,
                  const Truth& truth,
                  const Experiment& experiment,
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
  Measure(motion, truth, samples, [&](double t, const MotionState& state, bool has_arrived) {
    const Eigen::Vector3d p = state.body_in_world + normal3(position_noise, sensor.position_noise);
    const Eigen::Vector3d turn = normal3(angle_noise, sensor.angle_noise);
    const double angle = turn.norm();
    const Eigen::Quaterniond body_from_measured(Eigen::AngleAxisd(
        angle, angle > 0.0 ? Eigen::Vector3d(turn / angle) : Eigen::Vector3d::UnitX()));
    const Eigen::Quaterniond q = Eigen::Quaterniond(state.world_from_body) * body_from_measured;
    if (!has_arrived) return;
    std::vector<double> row = {p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()};
    for (double& number : row) number = RoundTo(number, sensor.resolution);
    AddRow(stream, RoundTo(experiment.start_time + t, kStampResolution), row);
  });
  return stream;
}

}  // namespace

Log Synthesize(const Vehicle& vehicle, const Experiment& experiment, std::uint64_t seed) {
  CHECK_GT(experiment.duration, 0.0);
  CHECK_GT(experiment.command_rate, 0.0);
  CHECK(!experiment.drives.empty());
  RequireAxesThatStay(experiment);
  Log log;
  log.name = experiment.name;
  log.dofs = DrivenDofs(vehicle, experiment);
  log.vehicle = vehicle.name;
  log.notes = experiment.notes;
  log.held_out = experiment.held_out;

  const VehicleMotion motion(vehicle, log.dofs);
  const Truth truth = Run(motion, experiment, seed);
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

}  // namespace fathom
