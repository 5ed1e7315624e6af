// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// The next experiment, from a model or a verdict and the limits of the place; or which stretches of
// ordinary dives do instead.
//
//   fathom_plan --model=surge.json --limits=tank.yaml --duration=120 --out=plan
//   fathom_plan --ordinary --log=dive_1 --log=dive_2 --dof=surge

#include "fathom/base/exit_code.h"
#include "fathom/base/files/input_file.h"
#include "fathom/base/files/output_file.h"
#include "fathom/base/input_error.h"
#include "fathom/planning/experiment_plan.h"
#include "fathom/planning/open_causes.h"
#include "fathom/planning/plan_experiment.h"
#include "fathom/planning/plan_files.h"
#include "fathom/planning/plan_limits.h"
#include "fathom/planning/plan_page.h"
#include "fathom/planning/plan_text.h"
#include "fathom/planning/thruster_files.h"
#include "fathom/planning/thruster_reach.h"
#include "fathom/report/page.h"
#include "fathom/report/table.h"
#include "fathom/signal/signals.h"
#include "fathom/tool/coupled_plan_run.h"
#include "fathom/tool/dof_flag.h"
#include "fathom/tool/flag_values.h"
#include "fathom/tool/flown_logs.h"
#include "fathom/tool/log_flags.h"
#include "fathom/tool/ordinary_plan.h"
#include "fathom/tool/origin_of_page.h"
#include "fathom/tool/output_flags.h"
#include "fathom/tool/plan_files.h"
#include "fathom/tool/print_text.h"
#include "fathom/tool/tool.h"
#include "fathom/vehicle/files/coupled_model_file.h"
#include "fathom/vehicle/files/model_file.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gflags/gflags.h>

DEFINE_string(model,
              "",
              "Model file (JSON), as fathom_identify writes it; with --dofs there, one of several "
              "DOFs.");
DEFINE_string(dofs,
              "",
              "Of a model of several DOFs, those to command: surge,yaw. Default: those that the "
              "limits file has a force for.");
DEFINE_string(verdict,
              "",
              "Verdict file (JSON), as fathom_diagnose writes it, instead of --model. If it is "
              "ambiguous, the plan tells its causes apart.");
DEFINE_string(limits,
              "",
              "Limits file (YAML): force, speed, distance, shortest hold. Without it, force and "
              "speed are at most those of the log, and the distance is not limited.");
DEFINE_string(
    vehicle,
    "",
    "Vehicle file (YAML) with thrusters: they give the force, each within its range. --out "
    "then holds their commands too.");
DEFINE_double(voltage,
              std::numeric_limits<double>::quiet_NaN(),
              "Supply of the thrusters [V], where the vehicle file's tables hold several.");
DEFINE_double(duration,
              std::numeric_limits<double>::quiet_NaN(),
              "Length of the experiment [s]; without it, the limits file's minutes.");
DEFINE_uint64(seed, 1, "Seed of the search: the same seed gives the same plan.");
DEFINE_string(out,
              "",
              "Folder for command.csv, experiment.yaml and plan.json, and what --vehicle adds.");
DEFINE_string(report, "", "Write a page to this file (HTML).");
DEFINE_bool(ordinary,
            false,
            "Plan no experiment: say which stretches of the ordinary dives of --log tell the "
            "parameters, and what to log.");
DEFINE_string(json, "", "With --ordinary: write what was found to this file (JSON).");

DECLARE_string(log);

namespace fathom {
namespace {

const ToolInfo kInfo = {
    .name = "fathom_plan",
    .summary = "Plans the next experiment: the command that tells most of what is still open.",
    .usage =
        "--model=FILE|--verdict=FILE [--limits=FILE --vehicle=FILE --duration=SECONDS --log=LOG "
        "--dofs=DOFS --seed=1 --out=FOLDER --report=PAGE.html]\n"
        "--ordinary --log=LOG [--log=LOG ... --dof=DOF --model=FILE --json=FILE "
        "--report=PAGE.html]",
    .example =
        "fathom_identify --log=data/flatfish --dof=surge --model=surge.json\n"
        "  fathom_plan --model=surge.json --limits=data/limits/tank.yaml --duration=120 "
        "--out=plan\n"
        "  fathom_synthesize --vehicle=data/vehicles/planar_rov.yaml "
        "--experiment=data/experiments/film_planar.yaml --out=boat\n"
        "  fathom_identify --log=boat --dofs=surge,sway,yaw --model=boat.json\n"
        "  fathom_plan --model=boat.json --limits=data/limits/lake.yaml --duration=120 "
        "--dofs=surge,yaw\n"
        "  fathom_plan --ordinary --log=data/flatfish --dof=surge",
    .details =
        "Prints the interval of each parameter now, after the planned experiment, and after a sine "
        "of the same length. --out holds command.csv, experiment.yaml for fathom_synthesize and "
        "plan.json; with --vehicle also thrusters.csv [N] and, by its tables of pulse widths, "
        "pulses.csv [us] and plan.lua, which plays them on ArduSub. "
        "--log names logs of the vehicle, with velocities, that the model was not fitted to: what "
        "they "
        "tell counts as flown already. "
        "A model or a verdict of several DOFs gives a wrench on several axes at once. "
        "--ordinary plans nothing: it says which stretches of the logs, cut at 30 to 120 s, tell "
        "the parameters about as well as all of them, and what manoeuvre or recorded channel the "
        "weakest one lacks. docs/plan.md.",
    .repeatable_flags = {"log"},
    .exit_codes =
        "0: a plan, or what ordinary dives tell; 1: input or flags cannot be used; 2: no command "
        "keeps the limits, or ordinary dives give no model"};

double DurationOf(const PlanLimits& limits) {
  if (std::isnan(FLAGS_duration)) {
    if (limits.duration) return *limits.duration;
    throw InputError(
        fmt::format("--duration: is missing, expected seconds, or `minutes` in {}.",
                    FLAGS_limits.empty() ? std::string("a limits file, --limits") : FLAGS_limits));
  }
  RequirePlannableDuration(FLAGS_duration);
  if (FLAGS_duration < limits.shortest_hold) {
    throw InputError(
        fmt::format("--duration: is {:g} s, expected the `shortest_hold` of {}, {:g} s, or more.",
                    FLAGS_duration,
                    FLAGS_limits.empty() ? std::string("the limits") : FLAGS_limits,
                    limits.shortest_hold));
  }
  return FLAGS_duration;
}

std::string InputFile() {
  if (FLAGS_model.empty() == FLAGS_verdict.empty()) {
    throw InputError(fmt::format("--model: is {}, expected either --model or --verdict.",
                                 FLAGS_model.empty() ? "missing" : "given beside --verdict"));
  }
  RequireOnePath("model", FLAGS_model);
  RequireOnePath("verdict", FLAGS_verdict);
  return FLAGS_model.empty() ? FLAGS_verdict : FLAGS_model;
}

void RequireVehicleForVoltage() {
  if (!FLAGS_vehicle.empty() || std::isnan(FLAGS_voltage)) return;
  throw InputError("--voltage: goes with --vehicle, expected none without it.");
}

// Nothing without --vehicle.
std::optional<Vehicle> VehicleFromFlag() {
  RequireVehicleForVoltage();
  if (FLAGS_vehicle.empty()) return std::nullopt;
  return ReadVehicleFile(FLAGS_vehicle);
}

void AddThrusters(const Vehicle& vehicle, PlanRequest* request) {
  request->vehicle = FLAGS_vehicle;
  request->thrusters =
      AllocateAlong({request->model.dof, {FLAGS_voltage, request->limits.thruster_force}},
                    vehicle,
                    FLAGS_vehicle);
  FitForceToThrusters(FLAGS_limits, request);
}

PlanLimits LimitsFromFlag(const std::string& file, const FittedModel& model) {
  if (!FLAGS_limits.empty()) return ReadPlanLimits(FLAGS_limits);
  const PlanLimits of_log = model.range ? LimitsOfLog(*model.range) : PlanLimits();
  if (of_log.force > 0.0 && of_log.speed > 0.0) return of_log;
  throw InputError(fmt::format(
      "--limits: is missing, expected a limits file, since {} does not say how much force and "
      "speed its log reached.",
      file));
}

void RequireDofOf(const FittedModel& model) {
  const std::optional<Dof> dof = DofFromFlag();
  if (!dof || *dof == model.dof) return;
  throw InputError(fmt::format(
      "--dof: is {}, expected {} as in the model, or none.", Name(*dof), Name(model.dof)));
}

void RequireFlagsOfLogs() {
  for (const char* flag : {"held_out", "velocity", "correct"}) {
    const std::string value = gflags::GetCommandLineFlagInfoOrDie(flag).current_value;
    if (value.empty()) continue;
    if (flag == std::string("held_out")) {
      throw InputError("--held_out: all of a log counts, expected none.");
    }
    if (FLAGS_log.empty()) {
      throw InputError(fmt::format("--{}: goes with --log, expected none without it.", flag));
    }
  }
}

void AddFlownLogs(const std::string& file, PlanRequest* request) {
  RequireDofOf(request->model);
  RequireFlagsOfLogs();
  if (FLAGS_log.empty()) return;
  const std::vector<Log> logs = ReadLogsFromFlags(request->model.dof);
  RequireOtherLogs(logs, request->model.log_fingerprints, file);
  for (const Log& log : logs) {
    const Signals signals = SignalsOf(log, request->model.dof, {.split_held_out = false});
    if (signals.force_unit != request->model.force_unit) {
      throw InputError(fmt::format("--log: commands of {} are in {}, expected {} as in {}.",
                                   log.path.string(),
                                   signals.force_unit,
                                   request->model.force_unit,
                                   file));
    }
    RequireSameVehicle(log, request->model, file);
    request->flown.insert(request->flown.end(), signals.train.begin(), signals.train.end());
  }
}

PlanRequest RequestFromFlags(const std::string& file, const std::optional<Vehicle>& vehicle) {
  const std::string text = ReadFile(file);
  PlanRequest request;
  request.name = file;
  request.model = ParseModel(file, text);
  request.limits = LimitsFromFlag(file, request.model);
  request.limits_are_of_log = FLAGS_limits.empty();
  request.duration = DurationOf(request.limits);
  request.seed = FLAGS_seed;
  if (vehicle) {
    AddThrusters(*vehicle, &request);
  } else {
    RequireNoThrusterForce(FLAGS_limits, request.limits.thruster_force);
  }
  RequirePlannable(request);
  AddFlownLogs(file, &request);
  if (FLAGS_verdict.empty()) return request;
  const OpenCauses open = ReadOpenCauses(file, text, request.model);
  for (const std::string& line : open.left_out) PrintText(stderr, "fathom_plan: " + line + "\n");
  request.rivals = open.rivals;
  if (open.noise > 0.0) request.model.train.mae = open.noise;
  return request;
}

std::map<std::string, std::string> FilesOf(const PlanRequest& request, const ExperimentPlan& plan) {
  std::map<std::string, std::string> files = {
      {"command.csv", FormatPlannedCommand(request.model.dof, plan)},
      {"experiment.yaml", FormatPlannedExperiment(request, plan)},
      {"plan.json", FormatPlan(request, plan)}};
  if (!request.thrusters) return files;
  files.merge(ThrusterFiles(Name(request.model.dof),
                            ThrustsOf(plan.command, *request.thrusters),
                            request.thrusters->thrusters));
  return files;
}

void Print(const PlanRequest& request, const ExperimentPlan& plan) {
  PrintText(stdout, PlanSentence(request, plan) + "\n\n");
  fmt::print("{}", FormatTable(PlannedParameterTable(plan.parameters)));
  if (!plan.separations.empty())
    fmt::print("\n{}", FormatTable(PlannedSeparationTable(plan.separations)));
  for (const std::string& line : PlanComments(request, plan)) {
    PrintText(stdout, "note: " + line + "\n");
  }
}

// The dives are over: nothing is commanded, so that nothing limits it.
int RunOrdinary() {
  for (const char* flag : {"verdict", "limits", "vehicle", "out", "dofs"}) {
    if (gflags::GetCommandLineFlagInfoOrDie(flag).current_value.empty()) continue;
    throw InputError(fmt::format(
        "--{}: goes with an experiment that is planned, expected none with --ordinary.", flag));
  }
  for (const auto& [flag, value] :
       {std::pair{"voltage", FLAGS_voltage}, {"duration", FLAGS_duration}}) {
    if (std::isnan(value)) continue;
    throw InputError(fmt::format(
        "--{}: goes with an experiment that is planned, expected none with --ordinary.", flag));
  }
  if (!gflags::GetCommandLineFlagInfoOrDie("seed").is_default) {
    throw InputError("--seed: goes with a search, expected none with --ordinary.");
  }
  return RunOrdinaryPlan({FLAGS_model, FLAGS_json, FLAGS_report});
}

// Of several DOFs a wrench is planned.
int RunCoupled(const std::string& file) {
  for (const char* flag : {"dof", "velocity"}) {
    if (gflags::GetCommandLineFlagInfoOrDie(flag).current_value.empty()) continue;
    throw InputError(fmt::format(
        "--{}: goes with a model of one DOF, expected none: {} is of several DOFs.", flag, file));
  }
  RequireFlagsOfLogs();
  RequireVehicleForVoltage();
  return RunCoupledPlan({file,
                         FLAGS_limits,
                         FLAGS_dofs,
                         FLAGS_duration,
                         FLAGS_seed,
                         FLAGS_vehicle,
                         FLAGS_voltage,
                         FLAGS_out,
                         FLAGS_report,
                         FLAGS_log.empty() ? std::vector<Log>() : ReadCoupledLogsFromFlags()});
}

int Run() {
  if (FLAGS_ordinary) return RunOrdinary();
  if (!FLAGS_json.empty()) {
    throw InputError("--json: goes with --ordinary, expected none: --out holds plan.json.");
  }
  const std::string file = InputFile();
  RequireOnePath("limits", FLAGS_limits);
  RequireOnePath("vehicle", FLAGS_vehicle);
  std::vector<OutputFlag> outputs = {{"report", FLAGS_report}};
  if (!FLAGS_out.empty()) {
    RequirePlanFolder(FLAGS_out);
    for (const char* name : kPlanFiles) {
      outputs.push_back({"out", (std::filesystem::path(FLAGS_out) / name).string()});
    }
  }
  std::vector<std::string> inputs = {file, FLAGS_limits, FLAGS_vehicle};
  for (const std::string& log : InputsFromFlags()) inputs.push_back(log);
  RequireOutputs(outputs, inputs);
  if (IsCoupledModel(ReadFile(file))) return RunCoupled(file);
  if (!FLAGS_dofs.empty()) {
    throw InputError(fmt::format(
        "--dofs: goes with a model of several DOFs, expected none: {} is of one.", file));
  }
  const std::optional<Vehicle> vehicle = VehicleFromFlag();
  const PlanRequest request = RequestFromFlags(file, vehicle);
  const ExperimentPlan plan = PlanExperiment(request);
  if (!plan.IsUsable()) {
    PrintText(stderr, fmt::format("fathom_plan: {}\n", plan.message));
    return kExitNoFit;
  }
  Print(request, plan);
  if (!FLAGS_out.empty()) WritePlanFiles(FLAGS_out, FilesOf(request, plan));
  if (!FLAGS_report.empty()) {
    Page page = PlanPage(request, plan);
    page.origin = OriginOfPage({});
    WriteFile(FLAGS_report, RenderPage(page));
  }
  return kExitUsable;
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) { return fathom::RunTool(argc, argv, fathom::kInfo, fathom::Run); }
