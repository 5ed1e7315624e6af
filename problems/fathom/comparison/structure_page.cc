// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/comparison/structure_page.h"

#include "fathom/base/names_of_dofs.h"
#include "fathom/base/not_known.h"
#include "fathom/comparison/structure_text.h"
#include "fathom/coupled/coupled_text.h"
#include "fathom/report/format_value.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kBetweenLogs = 1.0;  // [s]

// A segment on the time axis of all logs, which come one behind the other: their clocks may start
// anew.
struct PlacedStretch {
  std::size_t log, segment;
  double shift;  // from the log's clock [s]
};

std::vector<PlacedStretch> InOrder(const std::vector<CoupledData>& data) {
  std::vector<PlacedStretch> placed;
  double begin = 0.0;
  for (std::size_t log = 0; log < data.size(); ++log) {
    const std::vector<CoupledSegment>& segments = data[log].segments;
    if (segments.empty()) continue;
    const double shift = begin - segments.front().time.front();
    for (std::size_t s = 0; s < segments.size(); ++s) placed.push_back({log, s, shift});
    begin = segments.back().time.back() + shift + kBetweenLogs;
  }
  return placed;
}

void AppendStretch(const std::vector<Vector6>& velocity, Dof dof, Series* series) {
  for (const Vector6& of_sample : velocity) series->values.push_back(of_sample[Index(dof)]);
  series->values.push_back(kNotKnown);  // a gap
}

// What was measured, and free runs of the usable models; all faded but what was taken and the best
// models of one DOF each.
TimePanel PanelOfDof(const StructureComparison& comparison, Dof dof) {
  const std::vector<CoupledData>& data = comparison.data;
  const std::vector<PlacedStretch> placed = InOrder(data);
  TimePanel panel;
  if (data.size() > 1) panel.title = fmt::format("{} logs, one behind the other", data.size());
  panel.quantity = fmt::format("{} velocity", Name(dof));
  panel.unit = VelocityUnit(dof);
  panel.measured = Series{"measured", {}, ""};
  for (const PlacedStretch& place : placed) {
    const CoupledSegment& segment = data[place.log].segments[place.segment];
    for (const double t : segment.time) panel.time.push_back(t + place.shift);
    panel.time.push_back(panel.time.back());
    AppendStretch(segment.velocity, dof, &*panel.measured);
    if (!segment.is_held_out) continue;
    panel.held_out.push_back(
        {segment.time.front() + place.shift, segment.time.back() + place.shift});
  }
  const StructureRow* const taken = comparison.Taken();
  const StructureRow* const best = comparison.Best();
  for (const StructureRow& row : comparison.rows) {
    if (!row.is_usable) continue;
    Series& response = panel.responses.emplace_back();
    response.name = ModelName(row);
    response.note = fmt::format(
        "unseen NMAE {}", ShareText(row.unseen_nmae[static_cast<std::size_t>(Index(dof))], 3));
    response.is_faded = &row != taken && &row != best;
    for (const PlacedStretch& place : placed) {
      AppendStretch(row.prediction.velocity[place.log][place.segment], dof, &response);
    }
  }
  return panel;
}

PageSection SectionOfDof(const StructureComparison& comparison, Dof dof) {
  PageSection section;
  section.heading = fmt::format("Measured and simulated: {}", Name(dof));
  section.time_panels = {PanelOfDof(comparison, dof)};
  return section;
}

}  // namespace

Page StructurePage(const StructureComparison& comparison) {
  Page page;
  page.title = fmt::format("{}: structures compared", comparison.log_name);
  page.subtitle =
      fmt::format("Coupled models of {}, and models of one DOF each", NamesOf(comparison.dofs));
  page.lead = {StructureSentence(comparison)};
  if (const StructureRow* const taken = comparison.Taken()) {
    page.facts = {{"structure", ModelName(*taken)},
                  {"numbers", fmt::format("{}", taken->num_numbers)}};
  }
  PageSection& models = page.sections.emplace_back();
  models.heading = "Models";
  models.tables = {UnseenTable(comparison), FittedTable(comparison)};
  models.notes = CommentsOn(comparison);
  if (comparison.ladder) {
    Table ladder = LadderTable(*comparison.ladder, comparison.dofs);
    ladder.fold = "What auto tried";
    models.tables.push_back(std::move(ladder));
  }
  for (const Dof dof : comparison.dofs) page.sections.push_back(SectionOfDof(comparison, dof));
  page.footer = fmt::format(
      "Free runs by the command alone, begun anew from the measured state: every 5 s over data "
      "that were not fitted, every {:g} s in the charts. Data that were not fitted are other logs, "
      "or a quarter of each where there are fewer than four; each model is fitted anew to the "
      "rest.",
      comparison.window);
  return page;
}

}  // namespace fathom
