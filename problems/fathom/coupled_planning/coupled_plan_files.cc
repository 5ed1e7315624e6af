// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_planning/coupled_plan_files.h"

#include "fathom/base/files/json_text.h"
#include "fathom/planning/experiment_head.h"
#include "fathom/planning/ordinary_sine.h"
#include "fathom/planning/plan_entries.h"

#include <cmath>
#include <cstddef>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using CoupledJson = nlohmann::ordered_json;

// Of those DOFs that have one.
CoupledJson ByName(const std::array<double, 6>& values) {
  CoupledJson json = CoupledJson::object();
  for (const Dof dof : kAllDofs) {
    const double value = values[static_cast<std::size_t>(Index(dof))];
    if (std::isfinite(value) && value > 0.0) json[std::string(Name(dof))] = value;
  }
  return json;
}

// How the velocities are measured, of each modelled DOF.
CoupledJson VelocityJson(const CoupledPlanRequest& request, const CoupledPlan& plan) {
  CoupledJson colour = CoupledJson::object(), source = CoupledJson::object();
  for (const Dof dof : request.model.model.dofs) {
    const auto at = static_cast<std::size_t>(Index(dof));
    colour[std::string(Name(dof))] = plan.colour[at];
    source[std::string(Name(dof))] = Name(plan.noise_source[at]);
  }
  return {{"rate", plan.rate},
          {"noise", ByName(plan.noise)},
          {"colour", colour},
          {"noise_source", source}};
}

CoupledJson RoomJson(const CoupledLimits& limits) {
  CoupledJson json = CoupledJson::array();
  for (const ValueRange& range : limits.room) json.push_back(JsonOfRange<CoupledJson>(range));
  return json;
}

CoupledJson WrenchBlocksJson(const CoupledPlan& plan, double hold) {
  CoupledJson blocks = CoupledJson::array();
  int cell = 0;
  for (const WrenchBlock& block : plan.blocks) {
    CoupledJson along = CoupledJson::object();
    for (std::size_t k = 0; k < plan.axes.size(); ++k) {
      along[std::string(Name(plan.axes[k].dof))] = {{"kind", Name(block.along[k].kind)},
                                                    {"level", block.along[k].level}};
    }
    blocks.push_back(
        {{"from", cell * hold}, {"to", (cell + block.num_cells) * hold}, {"along", along}});
    cell += block.num_cells;
  }
  return blocks;
}

CoupledJson AxisSinesJson(const CoupledPlan& plan) {
  CoupledJson amplitude = CoupledJson::object();
  for (std::size_t k = 0; k < plan.axes.size(); ++k) {
    amplitude[std::string(Name(plan.axes[k].dof))] = plan.sine_amplitude[k];
  }
  return {{"amplitude", amplitude}, {"frequency", kSineFrequency}};
}

// Of each thruster its part in each DOF.
CoupledJson SharesJson(const CoupledPlan& plan) {
  CoupledJson list = CoupledJson::array();
  if (!plan.thrusters) return list;
  const ThrusterSet& thrusters = plan.thrusters->thrusters();
  for (std::size_t k = 0; k < thrusters.names.size(); ++k) {
    CoupledJson share = CoupledJson::object();
    for (std::size_t i = 0; i < plan.axes.size(); ++i) {
      share[std::string(Name(plan.axes[i].dof))] = plan.thrusters->along[i].share[k];
    }
    list.push_back({{"name", thrusters.names[k]},
                    {"share", share},
                    {"range", JsonOfRange<CoupledJson>(thrusters.range[k])}});
  }
  return list;
}

}  // namespace

std::string FormatCoupledPlan(const CoupledPlanRequest& request, const CoupledPlan& plan) {
  CoupledJson dofs = CoupledJson::array();
  for (const WrenchAxis& axis : plan.axes) dofs.push_back(Name(axis.dof));
  const CoupledJson json = {{"schema", "fathom-plan-2"},
                            {"model", request.name},
                            {"dofs", dofs},
                            {"seed", request.seed},
                            {"duration", plan.duration},
                            {"limits",
                             {{"force", ByName(request.limits.force)},
                              {"speed", ByName(request.limits.speed)},
                              {"distance", RoomJson(request.limits)},
                              {"tilt", request.limits.tilt},
                              {"heading", request.limits.heading},
                              {"thruster_force", request.limits.thruster_force},
                              {"shortest_hold", request.limits.shortest_hold}}},
                            {"velocity", VelocityJson(request, plan)},
                            {"models", plan.num_models},
                            {"share_breaking", plan.share_breaking},
                            {"parameters", JsonOfParameters<CoupledJson>(plan.parameters)},
                            {"left_out", plan.left_out},
                            {"separations", JsonOfSeparations<CoupledJson>(plan.separations)},
                            {"sine", AxisSinesJson(plan)},
                            {"thrusters", SharesJson(plan)},
                            {"blocks", WrenchBlocksJson(plan, request.limits.shortest_hold)}};
  return JsonText(json);
}

std::string FormatWrenchCommand(const CoupledPlan& plan) {
  std::string text = "t";
  for (const WrenchAxis& axis : plan.axes) text += fmt::format(",{}", ForceColumn(axis.dof));
  text += "\n";
  for (std::size_t i = 0; i < plan.command.time.size(); ++i) {
    text += fmt::format("{}", plan.command.time[i]);
    for (const WrenchAxis& axis : plan.axes) {
      text += fmt::format(",{}", plan.command.force[i][Index(axis.dof)]);
    }
    text += "\n";
  }
  return text;
}

std::string FormatWrenchExperiment(const CoupledPlanRequest& request, const CoupledPlan& plan) {
  std::string text = ExperimentHead("planned_wrench", plan.duration, request.limits.shortest_hold);
  for (const WrenchAxis& axis : plan.axes) {
    text += fmt::format("{}: {{control: open_loop, input: {{kind: file, file: command.csv}}}}\n",
                        Name(axis.dof));
  }
  std::vector<std::string> noise;
  for (const Dof dof : request.model.model.dofs) {
    noise.push_back(
        fmt::format("{}: {:.4g}", Name(dof), plan.noise[static_cast<std::size_t>(Index(dof))]));
  }
  return text + fmt::format("velocity:\n  rate: {:.4g}\n  noise: {{{}}}\n",
                            plan.rate,
                            fmt::join(noise, ", "));
}

}  // namespace fathom
