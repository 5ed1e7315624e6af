// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/chart_columns.h"

#include "fathom/report/seven_digits.h"

#include <utility>

#include <nlohmann/json.hpp>

namespace fathom {

std::string ColumnsJson(std::span<const ChartColumn> columns) {
  using nlohmann::json;
  json list = json::array();
  for (const ChartColumn& column : columns) {
    json values = json::array();
    for (const double value : column.values) values.push_back(ToSevenDigits(value));
    list.push_back({{"name", column.name}, {"values", std::move(values)}});
  }
  return list.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace fathom
