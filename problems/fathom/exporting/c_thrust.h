// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/exporting/export_model.h"

#include <string>

namespace fathom {

// What thrusters make of a command, as C text: dead zone, saturation, asymmetry and lag, in the
// order in which they act; docs/effects.md (3) to (10). `name` begins the functions' names. Of a
// model without these they give the command.
//
//   name_thrust(command, h, &thrusters, tau)   the mean force over a step of h, exact for a command
//                                              that is held over it
std::string CThrust(const ExportModel& model, const std::string& name);

}  // namespace fathom
