// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/files/vehicle_file.h"

#include "fathom/base/files/input_file.h"
#include "fathom/base/files/yaml_file.h"
#include "fathom/base/input_error.h"

#include <cmath>
#include <cstddef>
#include <string_view>

#include <fmt/format.h>

namespace fathom {
namespace {

double NumberAbove0(const YamlMap& map, std::string_view key) {
  const double number = map.Number(key);
  if (!(number > 0.0)) map.Fail(key, fmt::format("is {}, expected a number above 0.", number));
  return number;
}

double NumberAtLeast0(const YamlMap& map, std::string_view key) {
  const double number = map.Number(key);
  if (!(number >= 0.0))
    map.Fail(key, fmt::format("is {}, expected a number of at least 0.", number));
  return number;
}

Eigen::Vector3d Vector(const YamlMap& map, std::string_view key) {
  const std::vector<double> numbers = map.Numbers(key, 3);
  return {numbers[0], numbers[1], numbers[2]};
}

Thruster ReadThruster(const YamlMap& map) {
  Thruster thruster;
  thruster.name = map.String("name");
  thruster.position = Vector(map, "position");
  thruster.direction = Vector(map, "direction");
  const double length = thruster.direction.stableNorm();
  if (!(std::abs(length - 1.0) <= 1e-3)) {
    map.Fail("direction",
             fmt::format("has length {:.6g}, expected a unit vector (within 0.001).", length));
  }
  const YamlMap coefficient = map.Map("coefficient");
  thruster.forward_coefficient = NumberAbove0(coefficient, "forward");
  thruster.reverse_coefficient = NumberAtLeast0(coefficient, "reverse");
  return thruster;
}

UncoupledModel<double> ReadModel(const YamlMap& map) {
  UncoupledModel<double> model;
  model.inertia = NumberAbove0(map, "inertia");
  model.quadratic_damping = NumberAtLeast0(map, "quadratic_damping");
  model.linear_damping = NumberAtLeast0(map, "linear_damping");
  model.buoyancy = map.Number("buoyancy", 0.0);
  return model;
}

}  // namespace

Vehicle ReadVehicleFile(const std::filesystem::path& path) {
  return ParseVehicleFile(path.string(), ReadFile(path));
}

Vehicle ParseVehicleFile(const std::string& name, const std::string& text) {
  const YamlMap file = ParseYaml(name, text);
  Vehicle vehicle;
  vehicle.name = file.String("name");
  vehicle.mass = NumberAbove0(file, "mass");
  vehicle.size = Vector(file, "size");
  if (!(vehicle.size.minCoeff() > 0.0)) {
    file.Fail("size", "holds a number that is not above 0, expected length, width, height.");
  }
  for (const YamlMap& map : file.OptionalMaps("thrusters")) {
    vehicle.thrusters.push_back(ReadThruster(map));
  }
  if (const auto models = file.OptionalMap("models")) {
    for (const Dof dof : kAllDofs) {
      if (const auto map = models->OptionalMap(Name(dof))) {
        vehicle.models[Index(dof)] = ReadModel(*map);
      }
    }
  }
  file.Finish();
  return vehicle;
}

Stream ForcesFromThrusters(const Stream& command, const Vehicle& vehicle) {
  const std::size_t num_thrusters = vehicle.thrusters.size();
  std::vector<const std::vector<double>*> speeds;
  for (std::size_t i = 1; i <= num_thrusters; ++i) {
    speeds.push_back(command.Find(fmt::format("thruster_{}", i)));
    if (speeds.back() == nullptr) {
      throw InputError(
          fmt::format("command: column 'thruster_{}' is missing, expected one for each of the {} "
                      "thrusters of vehicle '{}'.",
                      i,
                      num_thrusters,
                      vehicle.name));
    }
  }
  if (num_thrusters == 0 || command.columns.size() != num_thrusters) {
    throw InputError(fmt::format(
        "command: holds {} columns, expected one for each of the {} thrusters of vehicle "
        "'{}'. Is this the vehicle of the log?",
        command.columns.size(),
        num_thrusters,
        vehicle.name));
  }

  const auto allocation = AllocationMatrix(vehicle.thrusters);
  Stream forces;
  forces.time = command.time;
  for (const Dof dof : kAllDofs) forces.columns.emplace_back(ForceColumn(dof));
  forces.values.assign(6, std::vector<double>(command.time.size()));
  Eigen::VectorXd thrust(num_thrusters);
  for (std::size_t row = 0; row < command.time.size(); ++row) {
    for (std::size_t i = 0; i < num_thrusters; ++i) {
      thrust[i] = vehicle.thrusters[i].Thrust((*speeds[i])[row]);
    }
    const Eigen::Matrix<double, 6, 1> tau = allocation * thrust;
    if (!tau.allFinite()) {
      throw InputError(fmt::format(
          "command: the thruster speeds at t = {} give a force that is not finite, expected "
          "speeds in Hz.",
          command.time[row]));
    }
    for (const Dof dof : kAllDofs) forces.values[Index(dof)][row] = tau[Index(dof)];
  }
  return forces;
}

}  // namespace fathom
