// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/manoeuvres/manoeuvre_prediction.h"
#include "fathom/report/format_value.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kRounding = 1e-9;  // of a figure

}  // namespace

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
    // What no number of the fit moves, as a rudder of known force, scatters by rounding alone.
    const bool is_known =
        std::isfinite(half) && half > kRounding * std::abs(prediction.figure.value);
    const auto text = [&](double value) {
      return is_known && std::isfinite(value) ? RoundedAt(value, DecimalsFor(half))
                                              : FormatValue(value);
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
