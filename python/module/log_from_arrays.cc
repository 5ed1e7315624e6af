// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "module/log_from_arrays.h"

#include "fathom/base/input_error.h"
#include "fathom/base/quoted.h"
#include "fathom/log/hold_out.h"
#include "fathom/log/log_text.h"
#include "fathom/open_log/open_log.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <utility>

#include "module/arrays.h"
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace fathom {

namespace py = pybind11;

namespace {

struct NamedColumn {
  std::string name;
  std::vector<double> values;
};

bool IsPlainName(const std::string& name) {
  return !name.empty() && std::ranges::all_of(name, [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_';
  });
}

// The columns of one stream, "t" first.
std::vector<NamedColumn> ColumnsOf(const std::string& stream, const py::object& arrays) {
  if (!py::isinstance<py::dict>(arrays)) {
    throw InputError(fmt::format(
        "{}: expected a dict from names of columns to arrays, \"t\" among them.", stream));
  }
  std::vector<NamedColumn> columns;
  for (const auto& [key, values] : py::reinterpret_borrow<py::dict>(arrays)) {
    const std::string name = py::str(key);
    const std::string what = fmt::format("{}[{}]", stream, Quoted(name));
    if (!IsPlainName(name)) {
      throw InputError(what + ": expected a name of letters, digits and underscores.");
    }
    columns.push_back({name, FiniteNumbers(what, values)});
  }
  const auto is_time = [](const NamedColumn& column) { return column.name == "t"; };
  const auto time = std::ranges::find_if(columns, is_time);
  if (time == columns.end()) {
    throw InputError(fmt::format("{}: has no \"t\", expected the stamps [s].", stream));
  }
  std::rotate(columns.begin(), time, std::next(time));
  return columns;
}

void RequireSoundColumns(const std::string& stream, const std::vector<NamedColumn>& columns) {
  const std::vector<double>& time = columns.front().values;
  for (const NamedColumn& column : columns) {
    if (column.values.size() == time.size()) continue;
    throw InputError(fmt::format("{}[{}]: has {} values, expected {}, as many as \"t\".",
                                 stream,
                                 Quoted(column.name),
                                 column.values.size(),
                                 time.size()));
  }
  for (std::size_t i = 1; i < time.size(); ++i) {
    if (time[i - 1] < time[i]) continue;
    throw InputError(fmt::format("{}['t'][{}]: is {} behind {}, expected stamps that rise.",
                                 stream,
                                 i,
                                 time[i],
                                 time[i - 1]));
  }
}

// As a CSV file of log folders, its numbers to the last bit.
std::optional<LogText::File> FileOf(const std::string& stream, const py::object& arrays) {
  if (arrays.is_none()) return std::nullopt;
  const std::vector<NamedColumn> columns = ColumnsOf(stream, arrays);
  RequireSoundColumns(stream, columns);
  std::string text;
  for (const NamedColumn& column : columns) {
    text += (text.empty() ? "" : ",") + column.name;
  }
  auto out = std::back_inserter(text);
  for (std::size_t row = 0; row < columns.front().values.size(); ++row) {
    for (std::size_t k = 0; k < columns.size(); ++k) {
      fmt::format_to(out, "{}{}", k == 0 ? '\n' : ',', columns[k].values[row]);
    }
  }
  return LogText::File{.name = stream, .text = std::move(text)};
}

// As log.yaml, in the part of YAML that is JSON.
std::string YamlOf(const ArraysInfo& info) {
  nlohmann::json yaml = {{"name", info.name}, {"dof", info.dofs}};
  if (info.mass) yaml["mass"] = *info.mass;
  // Beside no log: from here on.
  if (!info.vehicle.empty()) yaml["vehicle"] = std::filesystem::absolute(info.vehicle).string();
  if (!info.command_unit.empty()) yaml["command_unit"] = info.command_unit;
  if (!info.thruster_unit.empty()) yaml["thruster_unit"] = info.thruster_unit;
  return yaml.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

OpenedLog LogFromArrays(const py::object& command,
                        const py::object& velocity,
                        const py::object& pose,
                        const ArraysInfo& info) {
  if (velocity.is_none() && pose.is_none()) {
    throw InputError("velocity: expected the vehicle's motion here or in pose.");
  }
  LogText text;
  text.path = info.name;
  text.log_yaml = {.name = "arguments", .text = YamlOf(info)};
  text.command = FileOf("command", command);
  text.velocity = FileOf("velocity", velocity);
  text.pose = FileOf("pose", pose);
  text.held_out = HeldOutOf(info.held_out);
  const py::gil_scoped_release release;
  Log log = OpenLogText(text);
  RequireHeldOutInside(text.held_out, {&log, 1});
  return {std::move(log), info.name, "", HeldOutText(info.held_out), true};
}

}  // namespace fathom
