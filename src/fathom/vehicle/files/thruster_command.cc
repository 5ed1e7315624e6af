// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/files/thruster_command.h"

#include "fathom/base/input_error.h"
#include "fathom/vehicle/thruster.h"

#include <algorithm>

#include <Eigen/Core>
#include <fmt/format.h>

namespace fathom {
namespace {

// The command of each thruster, in the order of the vehicle file.
std::vector<const std::vector<double>*> CommandsOf(const Stream& command, const Vehicle& vehicle) {
  const std::size_t num_thrusters = vehicle.thrusters.size();
  std::vector<const std::vector<double>*> commands;
  for (std::size_t i = 1; i <= num_thrusters; ++i) {
    commands.push_back(command.Find(fmt::format("thruster_{}", i)));
    if (commands.back() == nullptr) {
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
  return commands;
}

// `thrust(i, row, value)`: of thruster i under its command at a row.
template <typename Thrust>
Stream ThrustsOf(const Stream& command, const Vehicle& vehicle, const Thrust& thrust) {
  Stream thrusts{.time = command.time, .columns = {}, .values = {}};
  for (const std::vector<double>* values : CommandsOf(command, vehicle)) {
    const std::size_t i = thrusts.columns.size();
    thrusts.columns.push_back(fmt::format("thruster_{}", i + 1));
    auto& column = thrusts.values.emplace_back(values->size());
    for (std::size_t row = 0; row < column.size(); ++row) {
      column[row] = thrust(i, row, (*values)[row]);
    }
  }
  return thrusts;
}

}  // namespace

bool IsOfThrusters(const Stream& command) {
  return !command.columns.empty() && command.columns.front().starts_with("thruster_");
}

Stream ThrustsFromSpeeds(const Stream& command, const Vehicle& vehicle) {
  for (const Thruster& thruster : vehicle.thrusters) {
    if (thruster.forward_coefficient > 0.0) continue;
    throw InputError(fmt::format(
        "command: thruster '{}' of vehicle '{}' has {}, expected a coefficient to turn speeds in "
        "Hz into forces.{}",
        thruster.name,
        vehicle.name,
        thruster.thrust_table.empty() ? "no coefficient" : "a table of thrust over its command",
        thruster.thrust_table.empty()
            ? " Or is the command in N? Then log.yaml says `thruster_unit: N`."
            : " fathom_import turns commands into forces by such tables."));
  }
  return ThrustsOf(command, vehicle, [&](std::size_t i, std::size_t, double speed) {
    return vehicle.thrusters[i].Thrust(speed);
  });
}

Stream ThrustsFromTables(const Stream& command,
                         const std::string& unit,
                         const std::vector<double>& voltage,
                         const Vehicle& vehicle,
                         std::size_t* num_beyond) {
  std::vector<const ThrustTable*> tables;
  for (const Thruster& thruster : vehicle.thrusters) {
    const ThrustTable* table = TableOf(thruster, vehicle);
    if (table == nullptr || table->command_unit != unit) {
      throw InputError(fmt::format(
          "command: thruster '{}' of vehicle '{}' has no table over a command in '{}', expected a "
          "thrust_table to turn it into a force.",
          thruster.name,
          vehicle.name,
          unit));
    }
    tables.push_back(table);
  }
  std::vector<bool> is_beyond(command.time.size(), false);
  Stream thrusts = ThrustsOf(command, vehicle, [&](std::size_t i, std::size_t row, double value) {
    if (!tables[i]->Covers(value, voltage[row])) is_beyond[row] = true;
    return tables[i]->Thrust(value, voltage[row]);
  });
  *num_beyond = std::count(is_beyond.begin(), is_beyond.end(), true);
  return thrusts;
}

Stream ForcesOfThrusts(const Stream& thrusts, const Vehicle& vehicle) {
  const auto columns = CommandsOf(thrusts, vehicle);
  const auto allocation = AllocationMatrix(vehicle.thrusters);
  Stream forces{.time = thrusts.time, .columns = {}, .values = {}};
  for (const Dof dof : kAllDofs) forces.columns.emplace_back(ForceColumn(dof));
  forces.values.assign(6, std::vector<double>(thrusts.time.size()));
  Eigen::VectorXd at(std::ssize(columns));
  for (std::size_t row = 0; row < thrusts.time.size(); ++row) {
    for (std::size_t i = 0; i < columns.size(); ++i) at[i] = (*columns[i])[row];
    const Eigen::Matrix<double, 6, 1> tau = GeneralisedForces(allocation, at);
    if (!tau.allFinite()) {
      throw InputError(fmt::format(
          "command: the thrusters at t = {} give a force that is not finite, expected speeds in Hz "
          "or thrusts in N.",
          thrusts.time[row]));
    }
    for (const Dof dof : kAllDofs) forces.values[Index(dof)][row] = tau[Index(dof)];
  }
  return forces;
}

}  // namespace fathom
