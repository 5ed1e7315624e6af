// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/comparison/comparison_panels.h"

#include "fathom/base/not_known.h"
#include "fathom/comparison/recommendation.h"
#include "fathom/identification/identification_text.h"
#include "fathom/report/held_curve.h"
#include "fathom/simulate/free_run.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

// A scored segment on the time axis of a panel.
struct PlacedSegment {
  const Segment* segment;
  bool is_held_out;
  size_t log;
  double shift = 0.0;  // from the log's clock to the panel's [s]

  double from() const { return segment->time.front() + shift; }
  double to() const { return segment->time.back() + shift; }
};

// The scored segments, held out or not, in the order of time, which begins at 0. Logs come one
// behind the other: their clocks may start anew.
std::vector<PlacedSegment> InOrderOfTime(const DofComparison& comparison) {
  std::vector<PlacedSegment> placed;
  const auto add =
      [&](const std::vector<Segment>& segments, const std::vector<size_t>& logs, bool is_held_out) {
        for (size_t i = 0; i < segments.size(); ++i) {
          placed.push_back({&segments[i], is_held_out, logs.empty() ? 0 : logs[i]});
        }
      };
  add(comparison.scored.train, comparison.log_of_train, false);
  add(comparison.scored.held_out, comparison.log_of_held_out, true);
  std::sort(placed.begin(), placed.end(), [](const PlacedSegment& a, const PlacedSegment& b) {
    return std::pair(a.log, a.from()) < std::pair(b.log, b.from());
  });
  constexpr double kBetweenLogs = 1.0;  // [s]
  for (size_t i = 0; i < placed.size(); ++i) {
    const bool is_new_log = i == 0 || placed[i].log != placed[i - 1].log;
    const double begin = i == 0 ? 0.0 : placed[i - 1].to() + kBetweenLogs;
    placed[i].shift = is_new_log ? begin - placed[i].from() : placed[i - 1].shift;
  }
  return placed;
}

// How many logs the segments are of.
size_t NumLogs(const std::vector<PlacedSegment>& placed) {
  std::set<size_t> logs;
  for (const PlacedSegment& segment : placed) logs.insert(segment.log);
  return logs.size();
}

// Of data that are `which`: "held-out velocity NMAE 0.030", "held-out velocity diverges".
std::string NoteOn(const char* which, double nmae) {
  return std::isfinite(nmae) ? fmt::format("{}velocity NMAE {:.3f}", which, nmae)
                             : fmt::format("{}velocity diverges", which);
}

}  // namespace

TimePanel ResponsePanel(const DofComparison& comparison) {
  TimePanel panel;
  panel.quantity = fmt::format("{} velocity", Name(comparison.dof));
  panel.unit = VelocityUnit(comparison.dof);
  panel.measured = Series{"measured", {}, ""};
  const Identification* const taken = Recommend(comparison).taken;
  for (const Identification& row : comparison.rows) {
    if (!row.is_usable || !std::isfinite(row.fitted.train.nmae)) continue;
    Series& response = panel.responses.emplace_back();
    response.name = ModelName(row);
    response.note = NoteOn(comparison.HasHeldOut() ? "held-out " : "", ScoreOf(comparison, row));
    response.is_faded = taken != nullptr && &row != taken;
  }
  const std::vector<PlacedSegment> placed = InOrderOfTime(comparison);
  if (const size_t num_logs = NumLogs(placed); num_logs > 1) {
    panel.title = fmt::format("{} logs, one behind the other", num_logs);
  }
  for (const PlacedSegment& place : placed) {
    const Segment* const segment = place.segment;
    if (place.is_held_out) panel.held_out.push_back({place.from(), place.to()});
    for (const double t : segment->time) panel.time.push_back(t + place.shift);
    panel.time.push_back(place.to());  // a gap before the next segment
    auto& measured = panel.measured->values;
    measured.insert(measured.end(), segment->velocity.begin(), segment->velocity.end());
    measured.push_back(kNotKnown);
    size_t response = 0;
    for (const Identification& row : comparison.rows) {
      if (!row.is_usable || !std::isfinite(row.fitted.train.nmae)) continue;
      auto& values = panel.responses[response++].values;
      const auto run = FreeRunOver(*segment, {row.fitted.model});
      if (run) {
        values.insert(values.end(), run->predicted.begin(), run->predicted.end());
      } else {
        values.insert(values.end(), segment->time.size(), kNotKnown);
      }
      values.push_back(kNotKnown);
    }
  }
  return panel;
}

TimePanel CommandPanel(const DofComparison& comparison) {
  TimePanel panel =
      HeldCurvePanel(IsAngular(comparison.dof) ? "moment" : "force",
                     ParameterUnit(kBuoyancy, comparison.dof, comparison.scored.force_unit));
  for (const PlacedSegment& place : InOrderOfTime(comparison)) {
    const Segment& segment = *place.segment;
    AppendHeldCurve(segment.command.time,
                    segment.command.value,
                    {segment.time.front(), segment.time.back()},
                    place.shift,
                    &panel);
    if (place.is_held_out) panel.held_out.push_back({place.from(), place.to()});
  }
  return panel;
}

std::vector<ParameterPanel> ParameterPanels(const DofComparison& comparison) {
  std::vector<ParameterPanel> panels;
  for (int i = 0; i < kNumParameters; ++i) {
    ParameterPanel panel;
    panel.name = kParameterInfo[i].name;
    std::replace(panel.name.begin(), panel.name.end(), '_', ' ');
    panel.unit = ParameterUnit(i, comparison.dof, comparison.scored.force_unit);
    panel.lower_bound = kParameterInfo[i].lower_bound;
    for (const Identification& row : comparison.rows) {
      if (!row.is_usable) continue;
      panel.estimates.push_back(
          {ModelName(row), ToVector(row.fitted.model)[i], std::sqrt(row.fitted.covariance(i, i))});
    }
    panels.push_back(std::move(panel));
  }
  return panels;
}

}  // namespace fathom
