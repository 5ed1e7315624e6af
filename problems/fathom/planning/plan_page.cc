// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/plan_page.h"

#include "fathom/planning/plan_text.h"

#include <cmath>

#include <fmt/format.h>

namespace fathom {
namespace {

TimePanel CommandPanel(Dof dof, const ExperimentPlan& plan) {
  TimePanel panel;
  panel.quantity = fmt::format("{} command", Name(dof));
  panel.unit = ForceUnit(dof);
  panel.time = plan.command.time;
  Series& series = panel.responses.emplace_back();
  series.name = "planned";
  series.values = plan.command.value;
  panel.is_stepped = true;
  panel.has_residuals = false;
  return panel;
}

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
    line.values.assign(time.size(), limit);
  }
  return panel;
}

}  // namespace

Page PlanPage(const PlanRequest& request, const ExperimentPlan& plan) {
  const Dof dof = request.model.dof;
  const double speed = request.limits.speed;
  Page page;
  page.title = fmt::format("The next experiment: {}", Name(dof));
  page.subtitle = fmt::format("planned by {}", request.name);
  page.lead = {PlanSentence(request, plan)};
  page.facts = {{"Duration", fmt::format("{:g} s", plan.duration)},
                {"Greatest force", fmt::format("{:g} {}", request.limits.force, ForceUnit(dof))},
                {"Blocks", fmt::format("{}", plan.blocks.size())}};
  PageSection& section = page.sections.emplace_back();
  section.heading = "What to drive, and what will be known";
  section.text = PlanComments(request, plan);
  section.time_panels = {CommandPanel(dof, plan),
                         MotionPanel(fmt::format("{} velocity", Name(dof)),
                                     VelocityUnit(dof),
                                     plan.time,
                                     plan.speed,
                                     {-speed, speed}),
                         MotionPanel(fmt::format("{} displacement from the start", Name(dof)),
                                     DisplacementUnit(dof),
                                     plan.time,
                                     plan.displacement,
                                     request.limits.distance)};
  section.tables = {PlannedParameterTable(plan.parameters)};
  if (!plan.separations.empty()) section.tables.push_back(PlannedSeparationTable(plan));
  page.footer =
      "Intervals are predicted from the model so far: the better it is, the better they are. "
      "docs/plan.md.";
  return page;
}

}  // namespace fathom
