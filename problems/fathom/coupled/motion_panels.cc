// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/motion_panels.h"

#include "fathom/vehicle/coupled/six_vector.h"

#include <cstddef>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kLongestStep = 1.0;  // [s], beyond which a curve is not drawn through

// What a log has along one DOF, its segments one after the other.
TimePanel PanelOf(const CoupledData& log,
                  std::span<const NamedPrediction> predictions,
                  std::size_t index,
                  Dof dof) {
  TimePanel panel;
  panel.quantity = fmt::format("{} velocity", Name(dof));
  panel.unit = VelocityUnit(dof);
  Series measured;
  measured.name = "measured";
  for (const NamedPrediction& each : predictions) {
    panel.responses.emplace_back().name = each.name;
  }
  const auto append = [&](double time, double value, const auto& response) {
    panel.time.push_back(time);
    measured.values.push_back(value);
    for (std::size_t k = 0; k < predictions.size(); ++k) {
      panel.responses[k].values.push_back(response(k));
    }
  };
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t s = 0; s < log.segments.size(); ++s) {
    const CoupledSegment& stretch = log.segments[s];
    if (stretch.time.empty()) continue;
    if (!panel.time.empty() && stretch.time.front() - panel.time.back() > kLongestStep) {
      const double middle = 0.5 * (panel.time.back() + stretch.time.front());
      append(middle, kNone, [](std::size_t) { return kNone; });
    }
    for (std::size_t i = 0; i < stretch.time.size(); ++i) {
      append(stretch.time[i], stretch.velocity[i][Index(dof)], [&](std::size_t k) {
        return predictions[k].prediction->velocity[index][s][i][Index(dof)];
      });
    }
    if (stretch.is_held_out) {
      panel.held_out.push_back({stretch.time.front(), stretch.time.back()});
    }
  }
  panel.measured = std::move(measured);
  return panel;
}

}  // namespace

std::vector<TimePanel> MotionPanels(std::span<const CoupledData> logs,
                                    const std::vector<Dof>& dofs,
                                    std::span<const NamedPrediction> predictions) {
  std::vector<TimePanel> panels;
  for (const Dof dof : dofs) {
    for (std::size_t log = 0; log < logs.size(); ++log) {
      panels.push_back(PanelOf(logs[log], predictions, log, dof));
      panels.back().title = logs.size() > 1 ? fmt::format("{}, {}", Name(dof), logs[log].log)
                                            : std::string(Name(dof));
    }
  }
  return panels;
}

}  // namespace fathom
