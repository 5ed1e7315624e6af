// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/thrust_table.h"

#include <algorithm>
#include <cstddef>

namespace fathom {
namespace {

// Between which two of `points` a value lies, and how far from the first to the second: 0 to 1.
struct TablePlace {
  std::size_t first = 0;
  std::size_t second = 0;
  double share = 0.0;
};

TablePlace PlaceOf(double value, const std::vector<double>& points) {
  const auto after = std::upper_bound(points.begin(), points.end(), value);
  if (after == points.begin()) return {};
  if (after == points.end()) return {points.size() - 1, points.size() - 1, 0.0};
  const auto second = static_cast<std::size_t>(after - points.begin());
  const double step = points[second] - points[second - 1];
  return {second - 1, second, (value - points[second - 1]) / step};
}

}  // namespace

double ThrustTable::Thrust(double command, double voltage) const {
  if (command_unit == "us" && command == 0.0) return 0.0;
  const TablePlace row = PlaceOf(command, commands);
  const TablePlace column = PlaceOf(voltage, voltages);
  const auto at_command = [&](std::size_t v) {
    return thrust[row.first][v] + row.share * (thrust[row.second][v] - thrust[row.first][v]);
  };
  const double low = at_command(column.first);
  return low + column.share * (at_command(column.second) - low);
}

std::optional<double> ThrustTable::CommandFor(double wanted, double voltage) const {
  std::vector<double> given;
  for (const double command : commands) given.push_back(Thrust(command, voltage));
  if (given.front() > given.back()) {
    for (double& one : given) one = -one;
    wanted = -wanted;
  }
  const bool rises = std::is_sorted(given.begin(), given.end());
  if (!rises || wanted < given.front() || wanted > given.back()) return std::nullopt;
  const auto between = [&](std::size_t before) {
    const double share = (wanted - given[before]) / (given[before + 1] - given[before]);
    return commands[before] + share * (commands[before + 1] - commands[before]);
  };
  // The first and the last command that give as much.
  const auto at_least = static_cast<std::size_t>(
      std::lower_bound(given.begin(), given.end(), wanted) - given.begin());
  const auto above = static_cast<std::size_t>(std::upper_bound(given.begin(), given.end(), wanted) -
                                              given.begin());
  const double first = at_least == 0 ? commands.front() : between(at_least - 1);
  const double last = above == given.size() ? commands.back() : between(above - 1);
  return 0.5 * (first + last);
}

bool ThrustTable::Covers(double command, double voltage) const {
  const bool is_off = command_unit == "us" && command == 0.0;
  return (is_off || (commands.front() <= command && command <= commands.back())) &&
         voltages.front() <= voltage && voltage <= voltages.back();
}

}  // namespace fathom
