// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <vector>

namespace fathom {

// The measured thrust of a thruster over its command and its supply voltage, as its maker gives it:
// still water, steady. Between its points it is linear in both; beyond its ends it stays, as a
// speed controller does.
struct ThrustTable {
  std::string name;
  std::string command_unit;      // "us": pulse width; "1": share of full command, -1 to 1
  std::vector<double> voltages;  // [V], increasing, at least one
  std::vector<double> commands;  // increasing, at least two
  std::vector<std::vector<double>> thrust;  // thrust[command][voltage] [N]

  // [N]. A pulse of width 0 is none: no thrust.
  double Thrust(double command, double voltage) const;

  // The command that gives a thrust; where several do, as in a dead zone, the middle of them.
  // Nothing beyond the table's ends, and where thrust both rises and falls over the commands.
  std::optional<double> CommandFor(double thrust, double voltage) const;

  // Whether both lie within the table.
  bool Covers(double command, double voltage) const;
};

}  // namespace fathom
