// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/exporting/c_pulses.h"

#include "fathom/exporting/comment_text.h"
#include "fathom/vehicle/thrust_table.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

// Of each thruster the place of its table among the vehicle's; empty where one has none.
std::vector<std::size_t> TablesOfThrusters(const Vehicle& vehicle) {
  std::vector<std::size_t> places;
  for (const Thruster& thruster : vehicle.thrusters) {
    const ThrustTable* table = TableOf(thruster, vehicle);
    if (table == nullptr) return {};
    places.push_back(static_cast<std::size_t>(table - vehicle.thrust_tables.data()));
  }
  return places;
}

std::string ArrayOf(const std::string& name, const std::vector<double>& values) {
  std::vector<std::string> literals;
  literals.reserve(values.size());
  for (const double value : values) literals.push_back(LiteralOf(value));
  return fmt::format(
      "  static const double {}[{}] = {{{}}};\n", name, values.size(), fmt::join(literals, ", "));
}

std::string ArraysOf(const ThrustTable& table, std::size_t place) {
  std::string text = fmt::format(
      "  /* {}, over {} */\n",
      CommentText(table.name),
      table.command_unit == "us" ? "the pulse width [us]" : "the share of the full command");
  text += ArrayOf(fmt::format("voltages_{}", place), table.voltages) +
          ArrayOf(fmt::format("commands_{}", place), table.commands) +
          fmt::format("  static const double thrusts_{}[{}] = {{\n",
                      place,
                      table.commands.size() * table.voltages.size());
  for (const std::vector<double>& row : table.thrust) {
    std::vector<std::string> literals;
    for (const double thrust : row) literals.push_back(LiteralOf(thrust));
    text += fmt::format("      {},\n", fmt::join(literals, ", "));
  }
  return text + "  };\n";
}

std::string LookUp(const std::string& name) {
  return fmt::format(
      "/* Between which two of increasing points a value lies, and how far from the first to the\n"
      " * second: 0 to 1. */\n"
      "static inline double {0}_place(double value, const double *points, int num_points,\n"
      "                               int *first, int *second) {{\n"
      "  int after = 0;\n"
      "  while (after < num_points && points[after] <= value) ++after;\n"
      "  *first = after == 0 ? 0 : after - 1;\n"
      "  *second = after == num_points ? num_points - 1 : after;\n"
      "  if (*first == *second) return 0.0;\n"
      "  return (value - points[*first]) / (points[*second] - points[*first]);\n"
      "}}\n"
      "\n"
      "/* A thrust table: linear between its points, the same beyond its ends. */\n"
      "static inline double {0}_look_up(double command, double voltage, int num_commands,\n"
      "                                 const double *commands, int num_voltages,\n"
      "                                 const double *voltages, const double *thrusts) {{\n"
      "  int above, below, left, right;\n"
      "  const double down = {0}_place(command, commands, num_commands, &above, &below);\n"
      "  const double along = {0}_place(voltage, voltages, num_voltages, &left, &right);\n"
      "  const double *upper = thrusts + above * num_voltages;\n"
      "  const double *lower = thrusts + below * num_voltages;\n"
      "  const double low = upper[left] + down * (lower[left] - upper[left]);\n"
      "  const double high = upper[right] + down * (lower[right] - upper[right]);\n"
      "  return low + along * (high - low);\n"
      "}}\n"
      "\n",
      name);
}

}  // namespace

std::string CThrustOfPulse(const ExportTarget& target) {
  if (!target.vehicle) return "";
  const std::vector<std::size_t> places = TablesOfThrusters(*target.vehicle);
  if (places.empty()) return "";
  std::string arrays, cases;
  for (std::size_t k = 0; k < target.vehicle->thrust_tables.size(); ++k) {
    if (std::find(places.begin(), places.end(), k) == places.end()) continue;
    const ThrustTable& table = target.vehicle->thrust_tables[k];
    arrays += ArraysOf(table, k);
    cases += fmt::format(
        "    case {1}:\n"
        "      return {0}_look_up({2}, voltage, {3}, commands_{1}, {4}, voltages_{1},\n"
        "                         thrusts_{1});\n",
        target.name,
        k,
        table.command_unit == "us" ? "pulse" : "(pulse - 1500.0) / 400.0",
        table.commands.size(),
        table.voltages.size());
  }
  return LookUp(target.name) +
         fmt::format(
             "/* The thrust [N], still water, of a pulse width [us] at a voltage of the supply "
             "[V]. A pulse of\n"
             " * width 0 is an output that is off. Thrusters are counted from 0, as {0}_forces() "
             "has them. */\n"
             "static inline double {0}_thrust_of_pulse(int thruster, double pulse, double voltage) "
             "{{\n"
             "  static const int table[{1}] = {{{2}}};\n"
             "{3}"
             "  if (pulse == 0.0) return 0.0;\n"
             "  switch (table[thruster]) {{\n"
             "{4}"
             "    default:\n"
             "      return 0.0;\n"
             "  }}\n"
             "}}\n\n",
             target.name,
             places.size(),
             fmt::join(places, ", "),
             arrays,
             cases);
}

}  // namespace fathom
