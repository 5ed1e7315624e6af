// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/exporting/export_target.h"

#include <string>

namespace fathom {

// The thrust tables of the vehicle file as C text: ThrustTable::Thrust() of a pulse width.
//
//   name_thrust_of_pulse(thruster, pulse, voltage)   [N] of [us] and [V]
//
// A table over a share of the full command is entered at (pulse - 1500 us) / 400 us, the span of
// ArduSub's outputs. Empty unless all thrusters have a table.
std::string CThrustOfPulse(const ExportTarget& target);

}  // namespace fathom
