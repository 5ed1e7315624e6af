// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/plan_files.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using Json = nlohmann::ordered_json;

// No limit and not known are both null.
Json RangeJson(const ValueRange& range) { return Json::array({range.low, range.high}); }

Json LimitsJson(const PlanLimits& limits) {
  return {{"force", limits.force},
          {"speed", limits.speed},
          {"distance", RangeJson(limits.distance)},
          {"thruster_force", limits.thruster_force},
          {"shortest_hold", limits.shortest_hold},
          {"position_noise", limits.position.noise}};
}

Json BlocksJson(const ExperimentPlan& plan, double hold) {
  Json blocks = Json::array();
  int cell = 0;
  for (const CommandBlock& block : plan.blocks) {
    blocks.push_back({{"kind", Name(block.kind)},
                      {"from", cell * hold},
                      {"to", (cell + block.num_cells) * hold},
                      {"level", block.level}});
    cell += block.num_cells;
  }
  return blocks;
}

Json ParametersJson(const ExperimentPlan& plan) {
  Json parameters = Json::object();
  for (const PlannedParameter& parameter : plan.parameters) {
    parameters[parameter.name] = {{"value", parameter.value},
                                  {"std_before", parameter.before},
                                  {"std_after", parameter.after},
                                  {"std_with_log_so_far", parameter.with_log_so_far},
                                  {"std_after_sine", parameter.sine},
                                  {"unit", parameter.unit}};
  }
  return parameters;
}

Json ThrustersJson(const PlanRequest& request) {
  Json list = Json::array();
  if (!request.thrusters) return list;
  for (std::size_t k = 0; k < request.thrusters->thrusters.names.size(); ++k) {
    list.push_back({{"name", request.thrusters->thrusters.names[k]},
                    {"share", request.thrusters->share[k]},
                    {"range", RangeJson(request.thrusters->thrusters.range[k])}});
  }
  return list;
}

Json SeparationsJson(const ExperimentPlan& plan) {
  Json list = Json::array();
  for (const PlannedSeparation& separation : plan.separations) {
    list.push_back({{"truth", separation.truth},
                    {"assumed", separation.assumed},
                    {"sigmas", separation.sigmas},
                    {"sigmas_of_sine", separation.sine},
                    {"sigmas_with_positions", separation.with_positions}});
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
      {"speed_range", RangeJson(plan.speed_range)},
      {"distance_range", RangeJson(plan.distance_range)},
      {"parameters", ParametersJson(plan)},
      {"led_by", plan.led_by},
      {"separations", SeparationsJson(plan)},
      {"sine",
       {{"amplitude", plan.sine.amplitude},
        {"frequency", kSineFrequency},
        {"offset", plan.sine.offset}}},
      {"thrusters", ThrustersJson(request)},
      {"blocks", BlocksJson(plan, request.limits.shortest_hold)}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string FormatPlannedCommand(Dof dof, const ExperimentPlan& plan) {
  std::string text = fmt::format("t,{}\n", ForceColumn(dof));
  for (std::size_t i = 0; i < plan.command.time.size(); ++i) {
    text += fmt::format("{},{}\n", plan.command.time[i], plan.command.value[i]);
  }
  return text;
}

std::string FormatPlannedExperiment(const PlanRequest& request, const ExperimentPlan& plan) {
  // Whole periods of the command in a cell, ten a second or more.
  const double hold = request.limits.shortest_hold;
  const double rate = std::max(1.0, std::ceil(10.0 * hold - 1e-9)) / hold;
  return fmt::format(
      "# Planned by fathom_plan: fathom_synthesize plays the command.csv beside this file.\n"
      "name: planned_{0}\n"
      "duration: {1}\n"
      "command_rate: {2}\n"
      "{0}:\n"
      "  control: open_loop\n"
      "  input: {{kind: file, file: command.csv}}\n"
      "velocity:\n"
      "  rate: {3:.4g}\n"
      "  noise: {{{0}: {4:.4g}}}\n",
      Name(request.model.dof),
      plan.duration,
      rate,
      plan.measurement.rate,
      plan.measurement.noise);
}

}  // namespace fathom
