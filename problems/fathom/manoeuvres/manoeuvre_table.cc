// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/manoeuvres/manoeuvre_prediction.h"
#include "fathom/report/format_value.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

namespace fathom {

Table ManoeuvreTable(const ManoeuvrePrediction& report) {
  Table table;
  table.columns = {{"figure"}, {"value", true}, {"unit"}, {"95 % interval", true}};
  const auto any = [&](auto field) {
    return std::ranges::any_of(report.figures,
                               [&](const auto& f) { return (f.*field).has_value(); });
  };
  const bool has_measured = any(&PredictedFigure::measured),
             has_limit = any(&PredictedFigure::limit);
  if (has_measured) table.columns.push_back({"measured", true});
  if (has_limit) table.columns.push_back({"IMO: at most", true});
  for (const PredictedFigure& prediction : report.figures) {
    const double half = 0.5 * (prediction.high - prediction.low);
    const bool is_known = std::isfinite(half) && half > 0.0;
    const int decimals = is_known ? DecimalsFor(half) : 3;
    const auto text = [&](double value) {
      return std::isfinite(value) ? RoundedAt(value, decimals) : std::string("-");
    };
    table.rows.push_back(
        {{prediction.figure.name,
          text(prediction.figure.value),
          prediction.figure.unit,
          is_known ? fmt::format("{} ... {}", text(prediction.low), text(prediction.high)) : "-"}});
    auto& cells = table.rows.back().cells;
    if (has_measured) cells.push_back(prediction.measured ? text(*prediction.measured) : "-");
    if (has_limit) {
      cells.push_back(prediction.limit ? fmt::format("{:.1f}", *prediction.limit) : "-");
    }
  }
  return table;
}

}  // namespace fathom
