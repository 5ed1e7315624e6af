// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <string>
#include <vector>

namespace fathom {

struct ChartColumn {
  std::string name;  // with its unit
  std::vector<double> values;
};

// What a chart without script draws, as JSON for csv.js: a list of columns {name, values}, the
// numbers with seven digits.
std::string ColumnsJson(std::span<const ChartColumn> columns);

}  // namespace fathom
