// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/log/log.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <map>
#include <optional>
#include <span>
#include <string>

namespace fathom {

// What a log names as its vehicle file; nothing where that is none, or is not there. Throws
// InputError for a file that breaks the format.
std::optional<Vehicle> VehicleOf(const Log& log);

// The same of the first log that has one.
std::optional<Vehicle> FirstVehicleOf(std::span<const Log> logs);

// How much of the force that was commanded along a DOF each thruster had to give, by its name:
// the slope of its part over the whole, by least squares over the commands of all logs, each for
// as long as it held.
//
//   share_k = int B_jk T_k tau_j dt / int tau_j^2 dt            docs/archive_trends.md (9)
//
// The shares add up to 1. Empty where a log holds no thrusters, or nothing was commanded.
std::map<std::string, double> ThrusterSharesOf(std::span<const Log> logs, Dof dof);

}  // namespace fathom
