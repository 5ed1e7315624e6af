// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/scatter_columns.h"

#include "fathom/report/chart_columns.h"
#include "fathom/report/chart_frame.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace fathom {
namespace {

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

ChartColumn ColumnOf(const std::string& name,
                     const std::string& unit,
                     const std::vector<double>& values,
                     const std::vector<std::size_t>& points) {
  ChartColumn column = {NameWithUnit(name, unit), {}};
  for (const std::size_t point : points) column.values.push_back(values[point]);
  return column;
}

}  // namespace

std::size_t DrawnEvery(std::size_t num_points) {
  return std::max<std::size_t>((num_points + kMostPoints - 1) / kMostPoints, 1);
}

std::string ScatterColumnsJson(const ScatterPanel& panel) {
  const std::vector<std::size_t> points = DrawnPoints(panel);
  std::vector<ChartColumn> columns = {ColumnOf(panel.x_name, panel.x_unit, panel.x, points),
                                      ColumnOf(panel.y_name, panel.y_unit, panel.y, points)};
  if (!panel.second_y.empty()) {
    columns.push_back(ColumnOf(panel.second_name, panel.y_unit, panel.second_y, points));
  }
  return ColumnsJson(columns);
}

}  // namespace fathom
