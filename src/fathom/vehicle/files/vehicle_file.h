// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/log/log.h"
#include "fathom/vehicle/thrust_table.h"
#include "fathom/vehicle/thruster.h"
#include "fathom/vehicle/uncoupled_model.h"

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// What a vehicle file tells about a vehicle; docs/file_formats.md.
struct Vehicle {
  std::string name;
  std::optional<double> mass;           // dry [kg], above 0
  std::optional<Eigen::Vector3d> size;  // length, width, height [m], above 0
  // Mass plus added mass, by Index(Dof) [kg] or [kg m^2], above 0; what free decays are scaled by.
  std::array<std::optional<double>, 6> inertia;
  std::vector<Thruster> thrusters;         // may be empty: commands are then forces
  std::vector<ThrustTable> thrust_tables;  // that thrusters name

  // Its motion where that is known, by Index(Dof); what fathom_synthesize makes logs from.
  std::array<std::optional<UncoupledModel<double>>, 6> models;
};

// Throws InputError, naming file, line and key, for whatever breaks the format.
Vehicle ReadVehicleFile(const std::filesystem::path& path);

// The same from memory; `name` stands for the file in messages.
Vehicle ParseVehicleFile(const std::string& name, const std::string& text);

// The forces tau_surge ... tau_yaw of a command thruster_1, thruster_2, ... [Hz], at the same
// stamps.
//
//   tau = B T,   T_i = C_t Omega_i |Omega_i|                  docs/models.md (3), (4)
//
// thruster_1 is the first in the vehicle file. Throws InputError if the command has not one column
// for each thruster, a thruster has a table in place of a coefficient, or a force is not finite.
Stream ForcesFromThrusters(const Stream& command, const Vehicle& vehicle);

// The same of a command in the unit of the thrusters' tables, "us" or "1", under a supply of so
// many volts at each stamp. `num_beyond`: how many rows leave a table. Throws InputError if a
// thruster has no table, or one of another unit.
Stream ForcesFromTables(const Stream& command,
                        const std::string& unit,
                        const std::vector<double>& voltage,
                        const Vehicle& vehicle,
                        std::size_t* num_beyond);

}  // namespace fathom
