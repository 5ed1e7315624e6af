// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/log.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <cstddef>
#include <string>
#include <vector>

namespace fathom {

// Whether a command is one of thrusters, thruster_1, thruster_2, ..., not of forces tau_*.
bool IsOfThrusters(const Stream& command);

// The thrusts [N] of a command thruster_1, thruster_2, ... [Hz], in the order of the vehicle file,
// at the same stamps.
//
//   T_i = C_t Omega_i |Omega_i|                               docs/models.md (3)
//
// Throws InputError if the command has not one column for each thruster, or a thruster no
// coefficient.
Stream ThrustsFromSpeeds(const Stream& command, const Vehicle& vehicle);

// The same of a command in the unit of the thrusters' tables, "us" or "1", under a supply of so
// many volts at each stamp. `num_beyond`: how many rows leave a table. Throws InputError if a
// thruster has no table, or one of another unit.
Stream ThrustsFromTables(const Stream& command,
                         const std::string& unit,
                         const std::vector<double>& voltage,
                         const Vehicle& vehicle,
                         std::size_t* num_beyond);

// The forces tau_surge ... tau_yaw [N, N m] of thrusts thruster_1, thruster_2, ... [N], at the same
// stamps.
//
//   tau = B T                                                 docs/models.md (4)
//
// Throws InputError if there is not one column for each thruster, or a force is not finite.
Stream ForcesOfThrusts(const Stream& thrusts, const Vehicle& vehicle);

}  // namespace fathom
