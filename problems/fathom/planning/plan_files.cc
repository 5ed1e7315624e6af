// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/plan_files.h"

#include "fathom/base/files/json_text.h"
#include "fathom/planning/experiment_head.h"
#include "fathom/planning/plan_entries.h"

#include <cstddef>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using Json = nlohmann::ordered_json;

Json LimitsJson(const PlanLimits& limits) {
  return {{"force", limits.force},
          {"speed", limits.speed},
          {"distance", JsonOfRange<Json>(limits.distance)},
          {"thruster_force", limits.thruster_force},
          {"shortest_hold", limits.shortest_hold},
          {"position_noise", limits.position.noise}};
}

Json BlocksJson(const ExperimentPlan& plan, double hold) {
  Json blocks = Json::array();
  int cell = 0;
  for (const WrenchBlock& block : plan.blocks) {
    const CommandBlock& along = block.along.front();
    blocks.push_back({{"kind", Name(along.kind)},
                      {"from", cell * hold},
                      {"to", (cell + block.num_cells) * hold},
                      {"level", along.level}});
    cell += block.num_cells;
  }
  return blocks;
}

Json ThrustersJson(const PlanRequest& request) {
  Json list = Json::array();
  if (!request.thrusters) return list;
  for (std::size_t k = 0; k < request.thrusters->thrusters.names.size(); ++k) {
    list.push_back({{"name", request.thrusters->thrusters.names[k]},
                    {"share", request.thrusters->share[k]},
                    {"range", JsonOfRange<Json>(request.thrusters->thrusters.range[k])}});
  }
  return list;
}

}  // namespace

std::string FormatPlan(const PlanRequest& request, const ExperimentPlan& plan) {
  const Dof dof = request.model.dof;
  const Json json = {
      {"schema", "fathom-plan-1"},
      {"model", request.name},
      {"dof", Name(dof)},
      {"seed", request.seed},
      {"duration", plan.duration},
      {"limits", LimitsJson(request.limits)},
      {"velocity", {{"rate", plan.measurement.rate}, {"noise", plan.measurement.noise}}},
      {"models", plan.num_models},
      {"share_breaking", plan.share_breaking},
      {"speed_range", JsonOfRange<Json>(plan.speed_range)},
      {"distance_range", JsonOfRange<Json>(plan.distance_range)},
      {"parameters", JsonOfParameters<Json>(plan.parameters)},
      {"led_by", plan.led_by},
      {"separations", JsonOfSeparations<Json>(plan.separations)},
      {"sine",
       {{"amplitude", plan.sine.amplitude},
        {"frequency", kSineFrequency},
        {"offset", plan.sine.offset}}},
      {"thrusters", ThrustersJson(request)},
      {"blocks", BlocksJson(plan, request.limits.shortest_hold)}};
  return JsonText(json);
}

std::string FormatPlannedCommand(Dof dof, const ExperimentPlan& plan) {
  std::string text = fmt::format("t,{}\n", ForceColumn(dof));
  for (std::size_t i = 0; i < plan.command.time.size(); ++i) {
    text += fmt::format("{},{}\n", plan.command.time[i], plan.command.value[i]);
  }
  return text;
}

std::string FormatPlannedExperiment(const PlanRequest& request, const ExperimentPlan& plan) {
  const Dof dof = request.model.dof;
  return ExperimentHead(
             fmt::format("planned_{}", Name(dof)), plan.duration, request.limits.shortest_hold) +
         fmt::format(
             "{0}:\n"
             "  control: open_loop\n"
             "  input: {{kind: file, file: command.csv}}\n"
             "velocity:\n"
             "  rate: {1:.4g}\n"
             "  noise: {{{0}: {2:.4g}}}\n",
             Name(dof),
             plan.measurement.rate,
             plan.measurement.noise);
}

}  // namespace fathom
