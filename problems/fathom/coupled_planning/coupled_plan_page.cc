// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_planning/coupled_plan_page.h"

#include "fathom/coupled_planning/coupled_plan_text.h"
#include "fathom/planning/plan_panels.h"

#include <array>
#include <cstddef>

#include <fmt/format.h>

namespace fathom {

Page CoupledPlanPage(const CoupledPlanRequest& request, const CoupledPlan& plan) {
  constexpr std::array<const char*, 3> kWays = {"ahead", "to starboard", "down"};
  Page page;
  page.title = "The next experiment: several degrees of freedom";
  page.subtitle = fmt::format("planned by {}", request.name);
  page.lead = {CoupledPlanSentence(plan)};
  page.facts = {{"Duration", fmt::format("{:g} s", plan.duration)},
                {"Blocks", fmt::format("{}", plan.blocks.size())}};
  PageSection& section = page.sections.emplace_back();
  section.heading = "What to drive, and what will be known";
  section.text = CoupledPlanComments(request, plan);
  for (const WrenchAxis& axis : plan.axes) {
    std::vector<double> force;
    for (const Vector6& wrench : plan.command.force) force.push_back(wrench[Index(axis.dof)]);
    section.time_panels.push_back(CommandPanel(axis.dof, plan.command.time, force));
  }
  for (const Dof dof : request.model.model.dofs) {
    const auto at = static_cast<std::size_t>(Index(dof));
    const double speed = request.limits.speed[at];
    section.time_panels.push_back(MotionPanel(fmt::format("{} velocity", Name(dof)),
                                              VelocityUnit(dof),
                                              plan.time,
                                              plan.speed[at],
                                              {-speed, speed}));
    if (IsAngular(dof)) continue;
    section.time_panels.push_back(MotionPanel(fmt::format("{} from the start", kWays[at]),
                                              "m",
                                              plan.time,
                                              plan.position[at],
                                              request.limits.room[at]));
  }
  if (!plan.heading.value.empty()) {
    const double heading = request.limits.heading;
    section.time_panels.push_back(MotionPanel(
        "heading off the start's", "rad", plan.time, plan.heading, {-heading, heading}));
  }
  section.tables = {PlannedEntryTable(plan)};
  if (!plan.separations.empty()) section.tables.push_back(CoupledSeparationTable(plan));
  page.footer =
      "Intervals are predicted from the model so far: the better it is, the better they are. "
      "docs/plan.md.";
  return page;
}

}  // namespace fathom
