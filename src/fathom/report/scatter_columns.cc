// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/scatter_columns.h"

#include "fathom/report/format_value.h"
#include "fathom/report/seven_digits.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using nlohmann::json;

// The points with both numbers, of these every k-th.
std::vector<std::size_t> DrawnPoints(const ScatterPanel& panel) {
  std::vector<std::size_t> finite;
  for (std::size_t i = 0; i < panel.x.size(); ++i) {
    if (std::isfinite(panel.x[i]) && std::isfinite(panel.y[i])) finite.push_back(i);
  }
  const std::size_t every = DrawnEvery(finite.size());
  std::vector<std::size_t> drawn;
  for (std::size_t i = 0; i < finite.size(); i += every) drawn.push_back(finite[i]);
  return drawn;
}

json ColumnJson(const std::string& name,
                const std::string& unit,
                const std::vector<double>& values,
                const std::vector<std::size_t>& points) {
  json shown = json::array();
  for (const std::size_t point : points) shown.push_back(ToSevenDigits(values[point]));
  return {{"name", unit.empty() ? name : fmt::format("{} [{}]", name, UnitText(unit))},
          {"values", std::move(shown)}};
}

}  // namespace

std::size_t DrawnEvery(std::size_t num_points) {
  return std::max<std::size_t>((num_points + kMostPoints - 1) / kMostPoints, 1);
}

std::string ScatterColumnsJson(const ScatterPanel& panel) {
  const std::vector<std::size_t> points = DrawnPoints(panel);
  json columns = {ColumnJson(panel.x_name, panel.x_unit, panel.x, points),
                  ColumnJson(panel.y_name, panel.y_unit, panel.y, points)};
  if (!panel.second_y.empty()) {
    columns.push_back(ColumnJson(panel.second_name, panel.y_unit, panel.second_y, points));
  }
  return columns.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace fathom
