// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/log_streams.h"

#include "fathom/base/input_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

void RequireColumns(const std::string& name,
                    const Stream& stream,
                    std::initializer_list<const char*> columns,
                    const char* what) {
  for (const char* column : columns) {
    if (stream.Find(column) != nullptr) continue;
    throw InputError(fmt::format("{}:1: column '{}' is missing, expected all of {} for {}.",
                                 name,
                                 column,
                                 fmt::join(columns, ", "),
                                 what));
  }
}

}  // namespace

CsvTable ParseCommand(const std::string& name, const std::string& text) {
  CsvSpec spec;
  for (const Dof dof : kAllDofs) spec.at_least_one_of.emplace_back(ForceColumn(dof));
  spec.numbered = "thruster_";
  spec.named = {"fin_", "shaft_"};
  CsvTable table = ParseCsvTable(name, text, spec);

  const Stream& stream = table.stream;
  std::size_t num_thrusters = 0;
  for (const std::string& column : stream.columns) num_thrusters += column.starts_with("thruster_");
  if (num_thrusters == 0) return table;
  const auto num_others = std::ranges::count_if(stream.columns, [](const std::string& column) {
    return column.starts_with("fin_") || column.starts_with("shaft_");
  });
  if (num_thrusters + static_cast<std::size_t>(num_others) < stream.columns.size()) {
    throw InputError(name +
                     ":1: holds both tau_* and thruster_* columns, expected forces or thrusters. "
                     "Remove the one that was not commanded.");
  }
  for (std::size_t i = 1; i <= num_thrusters; ++i) {
    if (stream.Find(fmt::format("thruster_{}", i)) == nullptr) {
      throw InputError(
          fmt::format("{}:1: column 'thruster_{}' is missing, expected thruster_1 to "
                      "thruster_{} for {} columns.",
                      name,
                      i,
                      num_thrusters,
                      num_thrusters));
    }
  }
  return table;
}

CsvTable ParseVelocity(const std::string& name, const std::string& text) {
  CsvSpec spec;
  for (const Dof dof : kAllDofs) spec.at_least_one_of.emplace_back(VelocityColumn(dof));
  return ParseCsvTable(name, text, spec);
}

CsvTable ParsePose(const std::string& name, const std::string& text) {
  CsvSpec spec;
  spec.at_least_one_of = {"x", "y", "z", "qx", "qy", "qz", "qw"};
  CsvTable table = ParseCsvTable(name, text, spec);
  // Those of a trajectory file, which is for other readers.
  constexpr std::array<std::string_view, 6> kDeviations = {
      "sx", "sy", "sz", "sroll", "spitch", "syaw"};
  std::erase_if(table.not_read, [&](const std::string& column) {
    return std::ranges::find(kDeviations, column) != kDeviations.end();
  });
  const auto has = [&](const char* column) { return table.stream.Find(column) != nullptr; };
  if (has("x") || has("y")) RequireColumns(name, table.stream, {"x", "y", "z"}, "a position");
  if (!has("qx") && !has("qy") && !has("qz") && !has("qw")) return table;
  RequireColumns(name, table.stream, {"qx", "qy", "qz", "qw"}, "an attitude");

  const auto& qx = *table.stream.Find("qx");
  const auto& qy = *table.stream.Find("qy");
  const auto& qz = *table.stream.Find("qz");
  const auto& qw = *table.stream.Find("qw");
  constexpr double kTolerance = 1e-3;
  for (std::size_t row = 0; row < qx.size(); ++row) {
    const double norm = std::hypot(std::hypot(qx[row], qy[row]), std::hypot(qz[row], qw[row]));
    if (!(std::abs(norm - 1.0) <= kTolerance)) {
      throw InputError(
          fmt::format("{}:{}: columns 'qx', 'qy', 'qz', 'qw' have length {:.6g}, expected a unit "
                      "quaternion (within "
                      "{}). Check the order of the columns.",
                      name,
                      table.line_of_row[row],
                      norm,
                      kTolerance));
    }
  }
  return table;
}

CsvTable ParseDetections(const std::string& name, const std::string& text) {
  CsvSpec spec;
  spec.required = {"tag_id", "u0", "v0", "u1", "v1", "u2", "v2", "u3", "v3"};
  spec.allow_equal_stamps = true;
  CsvTable table = ParseCsvTable(name, text, spec);
  if (table.stream.time.front() == table.stream.time.back()) {
    throw InputError(fmt::format("{}: column 't' is {} in every row, expected at least two frames.",
                                 name,
                                 table.stream.time.front()));
  }
  const auto& ids = *table.stream.Find("tag_id");
  for (std::size_t row = 0; row < ids.size(); ++row) {
    if (ids[row] >= 0.0 && ids[row] <= std::numeric_limits<int>::max() &&
        ids[row] == std::floor(ids[row])) {
      continue;
    }
    throw InputError(fmt::format("{}:{}: column 'tag_id' is {}, expected a whole number from 0 on.",
                                 name,
                                 table.line_of_row[row],
                                 ids[row]));
  }
  return table;
}

}  // namespace fathom
