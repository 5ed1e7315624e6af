// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/time_chart_json.h"

#include "fathom/report/format_value.h"
#include "fathom/report/seven_digits.h"
#include "fathom/report/thinning.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <glog/logging.h>
#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using nlohmann::json;

constexpr double kEpoch = 1e6;       // stamps beyond this count from some epoch [s]
constexpr double kTimeDigits = 1e5;  // stamps are shown to 10 microseconds

json SeriesJson(const Series& series,
                std::string_view color,
                const std::vector<std::size_t>& indices) {
  json values = json::array();
  for (const std::size_t index : indices) values.push_back(ToSevenDigits(series.values[index]));
  json curve = {{"name", series.name},
                {"note", series.note},
                {"color", color},
                {"is_faded", series.is_faded},
                {"values", std::move(values)}};
  if (!series.half_width.empty()) {
    json low = json::array(), high = json::array();
    for (const std::size_t index : indices) {
      low.push_back(ToSevenDigits(series.values[index] - series.half_width[index]));
      high.push_back(ToSevenDigits(series.values[index] + series.half_width[index]));
    }
    curve["low"] = std::move(low);
    curve["high"] = std::move(high);
  }
  return curve;
}

}  // namespace

void CheckPanel(const TimePanel& panel) {
  CHECK(std::ranges::is_sorted(panel.time)) << panel.quantity;
  if (panel.measured) CHECK_EQ(panel.measured->values.size(), panel.time.size());
  for (const Series& response : panel.responses) {
    CHECK_EQ(response.values.size(), panel.time.size()) << response.name;
    if (response.half_width.empty()) continue;
    CHECK_EQ(response.half_width.size(), panel.time.size()) << response.name;
  }
}

std::vector<double> Residual(const Series& measured, const Series& response) {
  std::vector<double> residual(measured.values.size());
  std::ranges::transform(measured.values, response.values, residual.begin(), std::minus<>());
  return residual;
}

std::string TimeChartJson(const TimePanel& panel, Palette& palette) {
  CheckPanel(panel);
  const bool has_residuals = panel.has_residuals && panel.measured && !panel.responses.empty();

  std::vector<std::vector<double>> curves;
  if (panel.measured) curves.push_back(panel.measured->values);
  for (const Series& response : panel.responses) {
    curves.push_back(response.values);
    if (has_residuals) curves.push_back(Residual(*panel.measured, response));
  }
  const auto indices = ThinnedIndices(curves, panel.time.size(), kMostStamps);

  const double start = panel.time.empty() ? 0.0 : panel.time.front();
  const double time_offset = std::abs(start) > kEpoch ? std::floor(start) : 0.0;
  const auto shown_time = [&](double time) {
    return std::round((time - time_offset) * kTimeDigits) / kTimeDigits;
  };

  json time = json::array();
  for (const std::size_t index : indices) time.push_back(shown_time(panel.time[index]));
  json held_out = json::array();
  for (const TimeInterval& interval : panel.held_out) {
    held_out.push_back({shown_time(interval.from), shown_time(interval.to)});
  }
  const bool is_lone = !panel.measured && panel.responses.size() == 1;
  json responses = json::array();
  for (const Series& response : panel.responses) {
    const auto color = is_lone ? kLoneColor : palette.ColorOf(response.ColorName());
    responses.push_back(SeriesJson(response, color, indices));
  }

  json chart = {{"quantity", panel.quantity},
                {"unit", UnitText(panel.unit)},
                {"time", std::move(time)},
                {"time_offset", time_offset},
                {"responses", std::move(responses)},
                {"held_out", std::move(held_out)},
                {"is_stepped", panel.is_stepped},
                {"is_low", panel.is_low},
                {"has_residuals", has_residuals}};
  if (panel.measured) chart["measured"] = SeriesJson(*panel.measured, kMeasuredColor, indices);
  return chart.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace fathom
