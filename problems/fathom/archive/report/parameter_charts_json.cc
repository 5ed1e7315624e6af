// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/report/parameter_charts_json.h"

#include "fathom/base/dof.h"
#include "fathom/report/format_value.h"
#include "fathom/report/parameter_chart.h"
#include "fathom/report/seven_digits.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using nlohmann::json;
using Places = std::map<std::string, std::size_t>;

// DOFs in their usual order, unknown ones behind.
int OrderOf(const std::string& dof) {
  const auto known = DofFromName(dof);
  return known ? Index(*known) : static_cast<int>(kAllDofs.size());
}

struct DofOfVehicle {
  std::string vehicle, dof;
  auto operator<=>(const DofOfVehicle& other) const {
    return std::tuple(vehicle, OrderOf(dof), dof) <=>
           std::tuple(other.vehicle, OrderOf(other.dof), other.dof);
  }
};

using RowsOf = std::map<DofOfVehicle, std::vector<const DiveFitRow*>>;

// Of each vehicle the dives with a log or a joint fit of it.
std::map<std::string, std::set<std::string>> DivesByVehicle(const Tables& tables) {
  std::map<std::string, std::set<std::string>> dives;
  for (const LogRow& log : tables.logs) dives[log.vehicle].insert(log.dive);
  for (const DiveFitRow& fit : tables.dive_fits) dives[fit.vehicle].insert(fit.dive);
  return dives;
}

json ChangesJson(const Tables& tables,
                 const DofOfVehicle& key,
                 const std::string& parameter,
                 const Places& places) {
  json changes = json::array();
  for (const ChangeRow& row : tables.changes) {
    if (row.vehicle != key.vehicle || row.dof != key.dof || row.parameter != parameter) continue;
    const auto at = places.find(row.at);
    if (at == places.end()) continue;
    changes.push_back({{"kind", row.kind},
                       {"at", at->second},
                       {"name", row.at},
                       {"before", ToSevenDigits(row.before)},
                       {"after", ToSevenDigits(row.after)}});
  }
  return changes;
}

json OutliersJson(const ArchiveReport& report,
                  const DofOfVehicle& key,
                  const std::string& parameter,
                  const Places& places) {
  json outliers = json::array();
  for (const OutlierRow& one : report.tables.outliers) {
    if (one.vehicle != key.vehicle || one.dof != key.dof || one.parameter != parameter) continue;
    const auto place = places.find(one.dive);
    if (place != places.end()) outliers.push_back(place->second);
  }
  return outliers;
}

double LowerBoundOf(const std::string& parameter) {
  const auto found = std::ranges::find(kParameterInfo, parameter, &ParameterInfo::name);
  return found == kParameterInfo.end() ? -std::numeric_limits<double>::infinity()
                                       : found->lower_bound;
}

// The usable rows of one parameter.
json ChartJson(const std::vector<const DiveFitRow*>& rows, const Places& places) {
  ParameterPanel panel;
  panel.lower_bound = LowerBoundOf(rows.front()->parameter);
  json points = json::array();
  for (const DiveFitRow* row : rows) {
    panel.estimates.push_back({row->dive, row->value, row->std});
    points.push_back({places.at(row->dive),
                      ToSevenDigits(row->value),
                      ToSevenDigits(row->std),
                      FormatValue(row->value, row->std)});
  }
  const ChartRange range = RangeOf(panel);
  const std::vector<double> values = TicksOf(range);
  const double step = values.size() > 1 ? values[1] - values[0] : range.to - range.from;
  json ticks = json::array();
  for (const double tick : values) {
    ticks.push_back({ToSevenDigits(tick), TickLabel(tick, step)});
  }
  return {{"parameter", rows.front()->parameter},
          {"unit", rows.front()->unit == "1" ? "" : UnitText(rows.front()->unit)},
          {"lower_bound", panel.lower_bound},  // null where there is none
          {"range", {ToSevenDigits(range.from), ToSevenDigits(range.to)}},
          {"ticks", std::move(ticks)},
          {"points", std::move(points)}};
}

}  // namespace

std::string ParameterChartsJson(const ArchiveReport& report,
                                const std::vector<std::string>& dives) {
  RowsOf rows_of;
  for (const DiveFitRow& row : report.tables.dive_fits) {
    rows_of[{row.vehicle, row.dof}].push_back(&row);
  }
  const auto dives_of = DivesByVehicle(report.tables);
  json groups = json::array();
  for (const auto& [key, rows] : rows_of) {
    json indices = json::array();
    Places places;
    for (std::size_t i = 0; i < dives.size(); ++i) {
      if (!dives_of.at(key.vehicle).contains(dives[i])) continue;
      places[dives[i]] = indices.size();
      indices.push_back(i);
    }

    // Parameters in the order in which they come.
    std::vector<std::vector<const DiveFitRow*>> by_parameter;
    for (const DiveFitRow* row : rows) {
      if (!row->usable || !std::isfinite(row->value) || !places.contains(row->dive)) continue;
      const auto found = std::ranges::find_if(by_parameter, [&](const auto& others) {
        return others.front()->parameter == row->parameter;
      });
      if (found != by_parameter.end()) {
        found->push_back(row);
      } else {
        by_parameter.push_back({row});
      }
    }
    json charts = json::array();
    for (const auto& of_parameter : by_parameter) {
      json chart = ChartJson(of_parameter, places);
      const std::string& parameter = of_parameter.front()->parameter;
      chart["changes"] = ChangesJson(report.tables, key, parameter, places);
      chart["outliers"] = OutliersJson(report, key, parameter, places);
      charts.push_back(std::move(chart));
    }
    groups.push_back({{"vehicle", key.vehicle},
                      {"dof", key.dof},
                      {"dives", std::move(indices)},
                      {"charts", std::move(charts)}});
  }
  return groups.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace fathom
