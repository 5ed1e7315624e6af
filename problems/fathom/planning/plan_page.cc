// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/plan_page.h"

#include "fathom/planning/plan_panels.h"
#include "fathom/planning/plan_text.h"

#include <fmt/format.h>

namespace fathom {
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
  section.time_panels = {CommandPanel(dof, plan.command.time, plan.command.value),
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
  if (!plan.separations.empty()) section.tables.push_back(PlannedSeparationTable(plan.separations));
  page.footer =
      "Intervals are predicted from the model so far: the better it is, the better they are. "
      "docs/plan.md.";
  return page;
}

}  // namespace fathom
