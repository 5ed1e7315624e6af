// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/motion/coupled_truth.h"

#include "fathom/base/input_error.h"
#include "fathom/base/random_stream.h"
#include "fathom/synthesize/experiment/pid.h"
#include "fathom/synthesize/experiment/resolution.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <glog/logging.h>

namespace fathom {
namespace {

constexpr double kAngleResolution = 1e-6;  // of fins [rad]

[[noreturn]] void RefuseDrive(const Experiment& experiment, const std::string& problem) {
  throw InputError(fmt::format("experiment '{}': {}", experiment.name, problem));
}

void RequireDrivesOfModel(const Vehicle& vehicle, const Experiment& experiment) {
  const std::vector<Dof>& dofs = vehicle.coupled->dofs;
  for (const Drive& drive : experiment.drives) {
    const std::string_view name = Name(drive.dof);
    if (std::find(dofs.begin(), dofs.end(), drive.dof) == dofs.end()) {
      RefuseDrive(experiment,
                  fmt::format("drives {}, which the coupled model of vehicle '{}' does not move, "
                              "expected one of its `dofs`.",
                              name,
                              vehicle.name));
    }
    if (drive.pid && (drive.dof == Dof::kSurge || drive.dof == Dof::kSway)) {
      RefuseDrive(experiment,
                  fmt::format("{} is in closed loop, but the vehicle turns away from its world "
                              "coordinate, expected {} in open loop.",
                              name,
                              name));
    }
    if (drive.turbulence.force != 0.0) {
      RefuseDrive(experiment,
                  fmt::format("{} has turbulence, expected none: it does not act on coupled "
                              "vehicles.",
                              name));
    }
  }
}

// Refuses drives whose names the vehicle does not hold.
template <typename Actuator>
void RequireActuators(const Vehicle& vehicle,
                      const Experiment& experiment,
                      const std::vector<ActuatorDrive>& drives,
                      const std::vector<Actuator>& actuators,
                      std::string_view kind) {
  for (const ActuatorDrive& drive : drives) {
    const bool is_there = std::any_of(actuators.begin(), actuators.end(), [&](const Actuator& a) {
      return a.name == drive.name;
    });
    if (is_there) continue;
    RefuseDrive(experiment,
                fmt::format("drives the {} '{}', which vehicle '{}' does not have, expected a name "
                            "of its `{}s`.",
                            kind,
                            drive.name,
                            vehicle.name,
                            kind));
  }
}

// What a drive gives at the stamps of the command; 0 of an actuator that nothing drives.
std::vector<double> ValuesOf(const std::vector<ActuatorDrive>& drives,
                             const std::string& name,
                             std::string_view purpose,
                             double resolution,
                             const std::vector<double>& time,
                             double duration,
                             std::uint64_t seed) {
  std::vector<double> values(time.size(), 0.0);
  const auto drive = std::find_if(
      drives.begin(), drives.end(), [&](const ActuatorDrive& d) { return d.name == name; });
  if (drive == drives.end()) return values;
  InputSignal input = drive->input;
  RandomStream random(seed, fmt::format("input.{}.{}", purpose, name));
  DrawRandomParts(input, duration, random);
  for (std::size_t k = 0; k < time.size(); ++k) {
    values[k] = RoundTo(Value(input, time[k]), resolution);
  }
  return values;
}

// Refuses angles that the vehicle's fin does not reach.
void RequireReachable(const Experiment& experiment,
                      const Vehicle& vehicle,
                      const Fin& fin,
                      const std::vector<double>& angles) {
  if (!fin.largest_angle) return;
  const double farthest =
      *std::ranges::max_element(angles, {}, [](double angle) { return std::abs(angle); });
  if (std::abs(farthest) <= *fin.largest_angle) return;
  RefuseDrive(experiment,
              fmt::format("turns the fin '{}' to {:.4g} rad, expected at most {:.4g} rad to either "
                          "side, its `largest_angle` in the file of vehicle '{}'.",
                          fin.name,
                          farthest,
                          *fin.largest_angle,
                          vehicle.name));
}

// Of an angle that turns on and on: the one nearest to the last.
double Unwrapped(double angle, double last) {
  const double turn = 2.0 * std::numbers::pi;
  return angle + turn * std::round((last - angle) / turn);
}

// Where a controller of a DOF sees the vehicle, in the world.
class SeenPlace {
 public:
  double At(Dof dof, const CoupledState& state) {
    if (!IsAngular(dof)) return state.position[Index(dof)];
    const Eigen::Quaterniond q(state.attitude);
    const Eigen::Matrix3d r = q.toRotationMatrix();
    const std::array<double, 3> angles = {std::atan2(r(2, 1), r(2, 2)),
                                          std::asin(std::clamp(-r(2, 0), -1.0, 1.0)),
                                          std::atan2(r(1, 0), r(0, 0))};
    double& last = last_[static_cast<std::size_t>(Index(dof) - 3)];
    last = Unwrapped(angles[static_cast<std::size_t>(Index(dof) - 3)], last);
    return last;
  }

 private:
  std::array<double, 3> last_{};  // roll, pitch, yaw [rad]
};

// The force along one DOF, from stamp to stamp.
class CoupledDriver {
 public:
  CoupledDriver(const Experiment& experiment, const Drive& drive, std::uint64_t seed)
      : dof_(drive.dof),
        input_(drive.input),
        resolution_(experiment.command_resolution),
        measurement_(seed, "control." + std::string(Name(dof_))) {
    RandomStream random(seed, "input." + std::string(Name(dof_)));
    DrawRandomParts(input_, experiment.duration, random);
    if (drive.pid) pid_.emplace(*drive.pid, 1.0 / experiment.command_rate);
    if (experiment.pose) {
      noise_ = IsAngular(dof_) ? experiment.pose->angle_noise : experiment.pose->position_noise;
    }
  }

  Dof dof() const { return dof_; }
  bool IsControlled() const { return pid_.has_value(); }

  double Force(double stamp, const CoupledState& state) {
    const double value = Value(input_, stamp);
    if (!pid_) return RoundTo(value, resolution_);
    const double seen = place_.At(dof_, state) + noise_ * measurement_.Normal();
    return RoundTo(pid_->Force(value, seen), resolution_);
  }

 private:
  Dof dof_;
  InputSignal input_;
  double resolution_;
  double noise_ = 0.0;
  RandomStream measurement_;
  std::optional<Pid> pid_;
  SeenPlace place_;
};

CoupledOutputs RunOf(const CoupledTruth& truth,
                     const CoupledInputs& inputs,
                     const CoupledState& start,
                     const CoupledStamps& stamps) {
  CoupledOutputs outputs;
  if (!RunCoupled(truth.model, inputs, start, stamps, &outputs)) {
    throw InputError(
        fmt::format("vehicle '{}': its speed leaves the finite numbers, or it moves too fast to be "
                    "integrated. Check the units of its coupled_model and of the experiment's "
                    "forces.",
                    truth.vehicle));
  }
  return outputs;
}

// One row of forces, fins and shafts alone, which holds from its stamp on.
CoupledInputs RowOf(const CoupledInputs& all, std::size_t row) {
  const CoupledCommand& command = all.command;
  CoupledInputs inputs;
  inputs.log = all.log;
  inputs.command.time = {command.time[row]};
  inputs.command.force = {command.force[row]};
  for (const CommandedFin& fin : command.fins) {
    inputs.command.fins.push_back({fin.name, fin.arms, {fin.angle[row]}, fin.behind, fin.force});
  }
  for (const CommandedShaft& shaft : command.shafts) {
    inputs.command.shafts.push_back({shaft.shaft, shaft.push, {shaft.turns[row]}});
  }
  return inputs;
}

// Fills in the forces. Where a controller is at work the vehicle moves from stamp to stamp.
void DriveForces(const Experiment& experiment, std::uint64_t seed, CoupledTruth* truth) {
  CoupledCommand& command = truth->inputs.command;
  std::vector<CoupledDriver> drivers;
  for (const Drive& drive : experiment.drives) drivers.emplace_back(experiment, drive, seed);
  const bool is_controlled = std::any_of(
      drivers.begin(), drivers.end(), [](const CoupledDriver& d) { return d.IsControlled(); });
  command.force.assign(command.time.size(), Vector6::Zero());
  CoupledState state = truth->start;
  for (std::size_t k = 0; k < command.time.size(); ++k) {
    for (CoupledDriver& driver : drivers) {
      command.force[k][Index(driver.dof())] = driver.Force(command.time[k], state);
    }
    if (!is_controlled || k + 1 == command.time.size()) continue;
    state = RunOf(*truth,
                  RowOf(truth->inputs, k),
                  state,
                  {.start = command.time[k], .velocity = {}, .pose = {command.time[k + 1]}})
                .pose.back();
  }
}

}  // namespace

CoupledTruth DriveCoupled(const Vehicle& vehicle,
                          const Experiment& experiment,
                          std::uint64_t seed) {
  CHECK(vehicle.coupled);
  RequireDrivesOfModel(vehicle, experiment);
  RequireActuators(vehicle, experiment, experiment.thrusters, vehicle.thrusters, "thruster");
  RequireActuators(vehicle, experiment, experiment.fins, vehicle.fins, "fin");
  RequireActuators(vehicle, experiment, experiment.shafts, vehicle.shafts, "shaft");
  CoupledTruth truth;
  truth.vehicle = vehicle.name;
  truth.model = *vehicle.coupled;
  truth.inputs.log = experiment.name;
  truth.model.current = {{experiment.name, experiment.current}};
  for (const Drive& drive : experiment.drives) {
    truth.start.nu[Index(drive.dof)] = drive.initial_speed;
  }
  CoupledCommand& command = truth.inputs.command;
  for (int k = 0; k / experiment.command_rate < experiment.duration; ++k) {
    command.time.push_back(RoundTo(k / experiment.command_rate, kStampResolution));
  }
  if (!experiment.thrusters.empty()) {
    const auto allocation = AllocationMatrix(vehicle.thrusters);
    for (std::size_t k = 0; k < vehicle.thrusters.size(); ++k) {
      const std::string& name = vehicle.thrusters[k].name;
      command.thrusters.push_back({name,
                                   allocation.col(static_cast<Eigen::Index>(k)),
                                   ValuesOf(experiment.thrusters,
                                            name,
                                            "thruster",
                                            experiment.command_resolution,
                                            command.time,
                                            experiment.duration,
                                            seed)});
    }
  }
  for (const Fin& fin : vehicle.fins) {
    command.fins.push_back(
        {fin.name,
         ArmsOf(fin),
         ValuesOf(experiment.fins, fin.name, "fin", 0.0, command.time, experiment.duration, seed),
         fin.behind,
         FinForceOf(fin)});
    RequireReachable(experiment, vehicle, fin, command.fins.back().angle);
  }
  for (const Shaft& shaft : vehicle.shafts) {
    command.shafts.push_back(CommandedShaftOf(shaft));
    command.shafts.back().turns = ValuesOf(
        experiment.shafts, shaft.name, "shaft", 0.0, command.time, experiment.duration, seed);
  }
  if (!experiment.drives.empty()) DriveForces(experiment, seed, &truth);
  return truth;
}

std::vector<Vector6> VelocitiesAt(const CoupledTruth& truth, const std::vector<double>& time) {
  return RunOf(truth, truth.inputs, truth.start, {.start = 0.0, .velocity = time, .pose = {}})
      .velocity;
}

std::vector<CoupledState> PlacesAt(const CoupledTruth& truth, const std::vector<double>& time) {
  return RunOf(truth, truth.inputs, truth.start, {.start = 0.0, .velocity = {}, .pose = time}).pose;
}

}  // namespace fathom
