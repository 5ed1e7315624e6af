// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/files/vehicle_file.h"

#include "fathom/base/files/input_file.h"
#include "fathom/base/files/yaml_file.h"
#include "fathom/base/input_error.h"
#include "fathom/base/quoted.h"
#include "fathom/vehicle/files/coupled_yaml.h"
#include "fathom/vehicle/files/shaft_yaml.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

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

Eigen::Vector3d UnitVector(const YamlMap& map, std::string_view key) {
  const Eigen::Vector3d vector = Vector(map, key);
  const double length = vector.stableNorm();
  if (!(std::abs(length - 1.0) <= 1e-3)) {
    map.Fail(key, fmt::format("has length {:.6g}, expected a unit vector (within 0.001).", length));
  }
  return vector;
}

Eigen::Vector3d ReadSize(const YamlMap& map) {
  Eigen::Vector3d size = Vector(map, "size");
  if (!(size.minCoeff() > 0.0)) {
    map.Fail("size", "holds a number that is not above 0, expected length, width, height.");
  }
  return size;
}

void RequireIncreasing(const YamlMap& map,
                       std::string_view key,
                       const std::vector<double>& numbers) {
  if (std::adjacent_find(numbers.begin(), numbers.end(), std::greater_equal<>()) != numbers.end()) {
    map.Fail(key, "does not increase from one to the next.");
  }
}

ThrustTable ReadThrustTable(const YamlMap& map) {
  ThrustTable table;
  table.name = map.Name("name");
  map.Ignore("source");
  table.command_unit = map.String("command");
  if (table.command_unit != "us" && table.command_unit != "1") {
    map.Fail("command",
             fmt::format("is {}, expected us (pulse width) or 1 (share of full command).",
                         Quoted(table.command_unit)));
  }
  table.voltages = map.Numbers("voltages");
  if (table.voltages.empty() || !(table.voltages.front() > 0.0)) {
    map.Fail("voltages", "is empty or not above 0, expected volts.");
  }
  RequireIncreasing(map, "voltages", table.voltages);
  const int num_columns = 1 + static_cast<int>(table.voltages.size());
  for (const std::vector<double>& row : map.NumberLists("thrust", num_columns)) {
    table.commands.push_back(row.front());
    table.thrust.emplace_back(row.begin() + 1, row.end());
  }
  if (table.commands.size() < 2) map.Fail("thrust", "has less than two rows.");
  RequireIncreasing(map, "thrust", table.commands);
  return table;
}

// Of the tensor: rows, symmetric.
Eigen::Matrix3d ReadTensor(const YamlMap& map, std::string_view key) {
  const std::vector<std::vector<double>> rows = map.NumberLists(key, 3);
  if (rows.size() != 3) {
    map.Fail(key, fmt::format("has {} rows, expected 3 of 3 numbers each.", rows.size()));
  }
  Eigen::Matrix3d tensor;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      tensor(i, j) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
    }
  }
  if (!tensor.isApprox(tensor.transpose(), 1e-9)) {
    map.Fail(key, "is not symmetric, expected I_xy in both places.");
  }
  return tensor;
}

RigidBody ReadBody(const YamlMap& map, const std::optional<double>& mass) {
  RigidBody body;
  body.mass = mass;
  if (map.Has("inertia_tensor")) body.inertia_tensor = ReadTensor(map, "inertia_tensor");
  if (map.Has("centre_of_mass")) body.centre_of_mass = Vector(map, "centre_of_mass");
  if (map.Has("volume")) body.volume = NumberAbove0(map, "volume");
  if (map.Has("centre_of_buoyancy")) body.centre_of_buoyancy = Vector(map, "centre_of_buoyancy");
  const auto about_centre = InertiaAboutCentreOfMass(body);
  if (about_centre && !IsPossibleInertia(*about_centre)) {
    map.Fail("inertia_tensor",
             "is that of no body: about the centre of mass a principal moment is below 0 or above "
             "the sum of the two others. It is expected about the body's origin, in kg m^2.");
  }
  return body;
}

Thruster ReadThruster(const YamlMap& map, const std::vector<ThrustTable>& tables) {
  Thruster thruster;
  thruster.name = map.Name("name");
  thruster.position = Vector(map, "position");
  thruster.direction = UnitVector(map, "direction");
  thruster.thrust_table = map.String("thrust_table", "");
  if (!thruster.thrust_table.empty()) {
    const auto found = std::find_if(tables.begin(), tables.end(), [&](const auto& t) {
      return t.name == thruster.thrust_table;
    });
    if (found == tables.end()) {
      map.Fail("thrust_table",
               fmt::format("is {}, expected the name of one of the file's thrust_tables.",
                           Quoted(thruster.thrust_table)));
    }
    if (map.Has("coefficient")) map.Fail("coefficient", "stands beside a thrust_table.");
    return thruster;
  }
  if (const auto coefficient = map.OptionalMap("coefficient")) {
    thruster.forward_coefficient = NumberAbove0(*coefficient, "forward");
    thruster.reverse_coefficient = NumberAtLeast0(*coefficient, "reverse");
  }
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

Fin ReadFin(const YamlMap& map) {
  Fin fin;
  fin.name = map.Name("name");
  fin.position = Vector(map, "position");
  fin.axis = UnitVector(map, "axis");
  if (!(fin.axis.tail<2>().norm() > 0.1)) {
    map.Fail("axis", "is along x, expected the span of the fin, which stands across the flow.");
  }
  if (map.Has("area")) fin.area = NumberAbove0(map, "area");
  if (map.Has("lift_slope")) fin.lift_slope = NumberAbove0(map, "lift_slope");
  if (map.Has("largest_angle")) fin.largest_angle = NumberAbove0(map, "largest_angle");
  fin.behind = map.String("behind", "");
  return fin;
}

// Commands, gains and tables are given by name: one of two parts of a name would be meant.
template <typename Part>
void AddOfNewName(const YamlMap& map, std::string_view kind, Part part, std::vector<Part>* parts) {
  const bool is_twice =
      std::ranges::any_of(*parts, [&](const Part& other) { return other.name == part.name; });
  if (is_twice) {
    map.Fail("name", fmt::format("is that of another {}, expected each name once.", kind));
  }
  parts->push_back(std::move(part));
}

}  // namespace

const ThrustTable* TableOf(const Thruster& thruster, const Vehicle& vehicle) {
  for (const ThrustTable& table : vehicle.thrust_tables) {
    if (table.name == thruster.thrust_table) return &table;
  }
  return nullptr;
}

Vehicle ReadVehicleFile(const std::filesystem::path& path) {
  return ParseVehicleFile(path.string(), ReadFile(path));
}

Vehicle ParseVehicleFile(const std::string& name, const std::string& text) {
  const YamlMap file = ParseYaml(name, text);
  Vehicle vehicle;
  vehicle.name = file.Name("name");
  if (file.Has("mass")) vehicle.mass = NumberAbove0(file, "mass");
  if (file.Has("size")) vehicle.size = ReadSize(file);
  if (const auto inertia = file.OptionalMap("inertia")) {
    for (const Dof dof : kAllDofs) {
      if (inertia->Has(Name(dof))) vehicle.inertia[Index(dof)] = NumberAbove0(*inertia, Name(dof));
    }
  }
  vehicle.body.mass = vehicle.mass;
  if (const auto body = file.OptionalMap("rigid_body"))
    vehicle.body = ReadBody(*body, vehicle.mass);
  for (const YamlMap& map : file.OptionalMaps("thrust_tables")) {
    AddOfNewName(map, "thrust table", ReadThrustTable(map), &vehicle.thrust_tables);
  }
  for (const YamlMap& map : file.OptionalMaps("thrusters")) {
    AddOfNewName(map, "thruster", ReadThruster(map, vehicle.thrust_tables), &vehicle.thrusters);
  }
  for (const YamlMap& map : file.OptionalMaps("fins")) {
    AddOfNewName(map, "fin", ReadFin(map), &vehicle.fins);
  }
  vehicle.shafts = ReadShafts(file, vehicle.thrusters);
  if (const auto models = file.OptionalMap("models")) {
    for (const Dof dof : kAllDofs) {
      if (const auto map = models->OptionalMap(Name(dof))) {
        vehicle.models[Index(dof)] = ReadModel(*map);
      }
    }
  }
  if (const auto map = file.OptionalMap("coupled_model")) {
    if (file.Has("models")) {
      file.Fail("coupled_model", "stands beside 'models', expected one of them.");
    }
    vehicle.coupled =
        ReadCoupledYaml(*map, vehicle.body, vehicle.thrusters, vehicle.fins, vehicle.shafts);
  }
  file.Finish();
  return vehicle;
}

}  // namespace fathom
