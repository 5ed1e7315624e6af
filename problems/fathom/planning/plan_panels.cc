// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/plan_panels.h"

#include <cmath>
#include <cstddef>

#include <fmt/format.h>

namespace fathom {
namespace {

// The middle of the band, so that it is as wide to either side.
Series BandSeries(const PlannedBand& band) {
  Series series;
  series.name = "models that the log allows, 95 %";
  for (std::size_t i = 0; i < band.value.size(); ++i) {
    series.values.push_back(0.5 * (band.low[i] + band.high[i]));
    series.half_width.push_back(0.5 * (band.high[i] - band.low[i]));
  }
  return series;
}

}  // namespace

TimePanel CommandPanel(Dof dof, const std::vector<double>& time, const std::vector<double>& force) {
  TimePanel panel;
  panel.quantity = fmt::format("{} command", Name(dof));
  panel.unit = ForceUnit(dof);
  panel.time = time;
  Series& series = panel.responses.emplace_back();
  series.name = "planned";
  series.values = force;
  panel.is_stepped = true;
  panel.has_residuals = false;
  return panel;
}

TimePanel MotionPanel(const std::string& quantity,
                      std::string_view unit,
                      const std::vector<double>& time,
                      const PlannedBand& band,
                      const ValueRange& limits) {
  TimePanel panel;
  panel.quantity = quantity;
  panel.unit = unit;
  panel.time = time;
  panel.has_residuals = false;
  panel.responses.push_back(BandSeries(band));
  for (const double limit : {limits.low, limits.high}) {
    if (!std::isfinite(limit)) continue;
    Series& line = panel.responses.emplace_back();
    line.name = fmt::format("limit {:g} {}", limit, unit);
    line.color_name = "limit";
    line.values.assign(time.size(), limit);
  }
  return panel;
}

}  // namespace fathom
