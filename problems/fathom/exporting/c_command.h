// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/exporting/export_model.h"
#include "fathom/exporting/export_target.h"

#include <string>

namespace fathom {

// What drives a model, as C text. Of a vehicle without fins and shafts it is tau; else a struct
// name_command with tau, the angles of the fins, what they need of the race, and the revolutions of
// the shafts. docs/fins.md (1), (2).
struct CCommand {
  std::string text;       // the struct, and name_command_forces(nu, command, tau); else empty
  std::string parameter;  // "const double tau[6]", or "const boat_command *command"
  std::string argument;   // "tau", or "command"
};

// Takes the places of fins and shafts from the vehicle file. Throws InputError where the model has
// a fin and that file is missing or does not have the fin.
CCommand CommandInC(const ExportModel& model, const ExportTarget& target);

// name_fin_angles(), which moves the fins' angles towards their orders; empty where none lags.
// Needs name_lag().
std::string CFinAngles(const ExportModel& model, const ExportTarget& target);

}  // namespace fathom
