// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/coupled_plan_run.h"

#include "fathom/base/exit_code.h"
#include "fathom/base/files/input_file.h"
#include "fathom/base/files/output_file.h"
#include "fathom/base/input_error.h"
#include "fathom/coupled_planning/coupled_plan.h"
#include "fathom/coupled_planning/coupled_plan_files.h"
#include "fathom/coupled_planning/coupled_plan_page.h"
#include "fathom/coupled_planning/coupled_plan_text.h"
#include "fathom/coupled_planning/plan_coupled.h"
#include "fathom/coupled_planning/verdict_rivals.h"
#include "fathom/planning/thruster_files.h"
#include "fathom/planning/thruster_reach.h"
#include "fathom/report/page.h"
#include "fathom/report/table.h"
#include "fathom/simulate/coupled/coupled_data.h"
#include "fathom/tool/flag_values.h"
#include "fathom/tool/flown_logs.h"
#include "fathom/tool/origin_of_page.h"
#include "fathom/tool/plan_files.h"
#include "fathom/tool/print_text.h"
#include "fathom/vehicle/files/coupled_model_file.h"
#include "fathom/vehicle/files/thruster_shares.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kLongestDuration = 3600.0;  // [s]
constexpr double kShortestDuration = 5.0;

std::vector<CoupledData> FlownData(const std::vector<Log>& logs,
                                   const FittedCoupledModel& fitted,
                                   const std::string& file) {
  RequireOtherLogs(logs, fitted.log_fingerprints, file);
  std::vector<CoupledData> flown;
  for (const Log& log : logs) {
    const Vehicle vehicle = VehicleOf(log).value_or(Vehicle());
    flown.push_back(
        CoupledDataOf(log, fitted.model.dofs, vehicle.thrusters, vehicle.fins, vehicle.shafts));
    if (flown.back().force_unit == fitted.force_unit) continue;
    throw InputError(fmt::format("--log: commands of {} are in {}, expected {} as in {}.",
                                 log.path.string(),
                                 flown.back().force_unit,
                                 fitted.force_unit,
                                 file));
  }
  return flown;
}

CoupledPlanRequest RequestOf(const CoupledPlanFlags& flags, const Vehicle* vehicle) {
  if (flags.limits.empty()) {
    throw InputError(fmt::format(
        "--limits: is missing, expected a limits file: {} does not say how much force and speed "
        "its log reached.",
        flags.model));
  }
  CoupledPlanRequest request;
  request.name = flags.model;
  const std::string text = ReadFile(flags.model);
  request.model = ParseCoupledModel(flags.model, text);
  request.limits_name = flags.limits;
  request.limits = ParseCoupledLimits(flags.limits, ReadFile(flags.limits));
  request.seed = flags.seed;
  request.vehicle = vehicle;
  request.vehicle_name = flags.vehicle;
  request.voltage = flags.voltage;
  if (vehicle == nullptr) RequireNoThrusterForce(flags.limits, request.limits.thruster_force);
  for (const std::string& name : SplitAtCommas(flags.dofs)) {
    request.dofs.push_back(ParseFlag("dofs", name, ParseDof));
  }
  VerdictRivals open = ReadVerdictRivals(flags.model, text, request.model);
  for (const std::string& line : open.left_out) PrintText(stderr, "fathom_plan: " + line + "\n");
  request.rivals = std::move(open.pairs);
  request.flown = FlownData(flags.flown, request.model, flags.model);
  request.duration = flags.duration;
  if (!std::isnan(flags.duration)) {
    RequirePlannableDuration(flags.duration);
    return request;
  }
  if (!request.limits.duration) {
    throw InputError(
        fmt::format("--duration: is missing, expected seconds, or `minutes` in {}.", flags.limits));
  }
  request.duration = *request.limits.duration;
  return request;
}

std::map<std::string, std::string> FilesOf(const CoupledPlanRequest& request,
                                           const CoupledPlan& plan) {
  std::map<std::string, std::string> files = {
      {"command.csv", FormatWrenchCommand(plan)},
      {"experiment.yaml", FormatWrenchExperiment(request, plan)},
      {"plan.json", FormatCoupledPlan(request, plan)}};
  if (!plan.thrusters) return files;
  files.merge(ThrusterFiles(
      NamesOfAxes(plan), ThrustsOf(plan.command, *plan.thrusters), plan.thrusters->thrusters()));
  return files;
}

}  // namespace

int RunCoupledPlan(const CoupledPlanFlags& flags) {
  std::optional<Vehicle> vehicle;
  if (!flags.vehicle.empty()) vehicle = ReadVehicleFile(flags.vehicle);
  const CoupledPlanRequest request = RequestOf(flags, vehicle ? &*vehicle : nullptr);
  const CoupledPlan plan = PlanCoupledExperiment(request);
  if (!plan.IsUsable()) {
    PrintText(stderr, fmt::format("fathom_plan: {}\n", plan.message));
    return kExitNoFit;
  }
  PrintText(stdout, CoupledPlanSentence(plan) + "\n\n");
  fmt::print("{}", FormatTable(PlannedEntryTable(plan)));
  if (!plan.separations.empty()) fmt::print("\n{}", FormatTable(CoupledSeparationTable(plan)));
  for (const std::string& line : CoupledPlanComments(request, plan)) {
    PrintText(stdout, "note: " + line + "\n");
  }
  if (!flags.out.empty()) WritePlanFiles(flags.out, FilesOf(request, plan));
  if (!flags.report.empty()) {
    Page page = CoupledPlanPage(request, plan);
    page.origin = OriginOfPage({});
    WriteFile(flags.report, RenderPage(page));
  }
  return kExitUsable;
}

void RequirePlannableDuration(double duration) {
  if (duration >= kShortestDuration && duration <= kLongestDuration) return;
  throw InputError(fmt::format(
      "--duration: is {} s, expected {} to {} s.", duration, kShortestDuration, kLongestDuration));
}

}  // namespace fathom
