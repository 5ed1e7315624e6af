// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// What a model predicts for a log: a free run over its command, scored against its measurement.

#include "fathom/base/exit_code.h"
#include "fathom/base/files/input_file.h"
#include "fathom/base/files/output_file.h"
#include "fathom/base/input_error.h"
#include "fathom/findings/log_check.h"
#include "fathom/manoeuvres/manoeuvre_page.h"
#include "fathom/manoeuvres/manoeuvre_prediction.h"
#include "fathom/report/page.h"
#include "fathom/tool/coupled_scores.h"
#include "fathom/tool/dof_flag.h"
#include "fathom/tool/log_flags.h"
#include "fathom/tool/log_scores.h"
#include "fathom/tool/origin_of_page.h"
#include "fathom/tool/output_flags.h"
#include "fathom/tool/print_findings.h"
#include "fathom/tool/print_text.h"
#include "fathom/tool/tool.h"
#include "fathom/vehicle/files/coupled_model_file.h"
#include "fathom/vehicle/files/model_file.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gflags/gflags.h>

DEFINE_string(model, "", "Model or verdict file (JSON).");
DEFINE_string(out, "", "Write t and the predicted velocity to this CSV file, of a single log.");
DEFINE_string(json, "", "Write the scores to this JSON file.");
DEFINE_bool(
    keep_run_effects,
    false,
    "Keep effects of a run (a current, a bias, a lost thruster) also on other logs. Their times "
    "then count from this log's first command.");
DEFINE_double(horizon,
              std::numeric_limits<double>::infinity(),
              "Of a model of several DOFs: begin anew from the measured state after so long [s].");

DEFINE_string(
    manoeuvre,
    "",
    "Of a model of several DOFs: turning_circle:35, zigzag:10/10, spiral:25 or pull_out:20, "
    "in degrees of the rudder, a minus first for port; or stop, the thrust reversed, stop:50 "
    "by half of it, stop:0 off.");
DEFINE_double(
    rudder_delay,
    std::numeric_limits<double>::quiet_NaN(),
    "Of --manoeuvre=zigzag: from the heading's reaching the order to the rudder's answer [s]; "
    "otherwise as in the log.");
DEFINE_string(report, "", "Of --manoeuvre: write a page to this HTML file.");
DEFINE_string(table,
              "",
              "Of the same: the derivatives about a straight track and Nomoto's K and T, in si or "
              "prime (dimensionless).");
DEFINE_int32(draws, 200, "Of --manoeuvre and --table: models drawn for their intervals.");
DEFINE_uint64(seed, 1, "Of --manoeuvre and --table: seed of these draws.");

namespace fathom {
namespace {

const ToolInfo kInfo = {
    "fathom_simulate",
    "Predicts a log's velocity by simulating from its command alone, and scores the prediction.",
    "--model=FILE --log=LOG [--log=LOG ...] [--dof=DOF] [--velocity=FILE] [--out=FILE] "
    "[--json=FILE] [--keep_run_effects] [--horizon=SECONDS]\n"
    "--model=FILE --log=LOG --manoeuvre=MANOEUVRE [--out=TRACK] [--report=FILE] "
    "[--rudder_delay=SECONDS] | "
    "--table=si|prime",
    "fathom_identify --log=data/flatfish --dof=surge --model=surge.json\n"
    "  fathom_simulate --model=surge.json --log=data/flatfish --out=prediction.csv",
    "The prediction is at the stamps of the log's motion stream, or of its command if there is "
    "none. It starts where the model fits the first two seconds best, and anew after a gap of "
    "over 30 s and at the ends of held-out intervals. A verdict of "
    "fathom_diagnose is simulated with its causes, as the sensor would show it. The motion of "
    "other DOFs is taken from the log. Causes of a run are left out on any other log. "
    "Several logs, as --log=A --log=B or --log=A,B, are scored one by one. A model of several "
    "degrees of freedom (fathom_identify --dofs) is simulated as one; --horizon begins its runs "
    "anew: docs/coupled.md. --manoeuvre plays a turning circle, a zigzag, a spiral, a pull-out or "
    "a "
    "stop, from the log's first speed under its mean force, and --table lists the derivatives "
    "there: "
    "docs/fins.md.",
    {"log"}};

void PrintRemarks(const std::vector<std::string>& remarks) {
  for (const std::string& remark : remarks) PrintText(stdout, "note: " + remark + "\n");
}

void Print(const LogScore& score, const Log& log, const FittedModel& model) {
  if (!score.prediction) {
    std::fflush(stdout);
    fmt::print(stderr,
               "fathom_simulate: the simulation of {} over {} diverges or is too stiff: inertia "
               "{:g}, linear damping {:g}.\n",
               FLAGS_model,
               log.path.string(),
               model.model.inertia,
               model.model.linear_damping);
    return;
  }
  fmt::print("{}", LogScoreText(score, log, model));
  PrintRemarks(score.remarks);
}

// Throws InputError if --dof is given and the model is of another one.
void RequireDofOf(const FittedModel& model) {
  const std::optional<Dof> dof = DofFromFlag();
  if (!dof || *dof == model.dof) return;
  throw InputError(fmt::format("--dof: is {}, but {} is a model of {}: expected {}, or no --dof.",
                               Name(*dof),
                               FLAGS_model,
                               Name(model.dof),
                               Name(model.dof)));
}

void RequireOneLogForOut(std::size_t num_logs) {
  if (FLAGS_out.empty() || num_logs == 1) return;
  throw InputError("--out: holds the prediction of one log, expected a single --log with it.");
}

void PrintPrediction(const ManoeuvrePrediction& report) {
  PrintText(stdout, FormatTable(ManoeuvreTable(report)));
  if (report.num_astray > 0) {
    fmt::print("note: {} of {} drawn models cannot be or diverge; the intervals are of the rest.\n",
               report.num_astray,
               report.num_draws);
  }
}

std::optional<double> RudderDelayFromFlag(const Manoeuvre& manoeuvre) {
  if (std::isnan(FLAGS_rudder_delay)) return std::nullopt;
  if (manoeuvre.kind != Manoeuvre::Kind::kZigzag) {
    throw InputError("--rudder_delay: goes with --manoeuvre=zigzag:10/10, expected none.");
  }
  if (!(FLAGS_rudder_delay >= 0.0 && std::isfinite(FLAGS_rudder_delay))) {
    throw InputError(
        fmt::format("--rudder_delay: is {}, expected 0 s or more.", FLAGS_rudder_delay));
  }
  return FLAGS_rudder_delay;
}

int RunSteeringOf(const FittedCoupledModel& fitted, const Log& log) {
  const ManoeuvrePrediction report =
      PredictSteering(fitted, log, ParseSteeringUnits(FLAGS_table), {FLAGS_draws, FLAGS_seed});
  fmt::print("Small motions about a straight track at {:.3g} m/s, as in {}; angles to starboard:\n",
             report.ahead,
             log.name);
  PrintPrediction(report);
  for (const std::string& sentence : report.sentences) PrintText(stdout, sentence + "\n");
  return kExitUsable;
}

int RunManoeuvreOf(const FittedCoupledModel& fitted, const Log& log) {
  if (FLAGS_draws < 0) {
    throw InputError(fmt::format("--draws: is {}, expected 0 or more.", FLAGS_draws));
  }
  if (!FLAGS_table.empty() && !FLAGS_manoeuvre.empty()) {
    throw InputError("--table: is given beside --manoeuvre, expected one of them.");
  }
  if (!FLAGS_table.empty()) return RunSteeringOf(fitted, log);
  const Manoeuvre manoeuvre = ParseManoeuvre(FLAGS_manoeuvre);
  const ManoeuvrePrediction report = PredictManoeuvre(
      fitted, log, manoeuvre, {FLAGS_draws, FLAGS_seed}, RudderDelayFromFlag(manoeuvre));
  fmt::print("{} from {:.3g} m/s, as in {}:\n", FLAGS_manoeuvre, report.ahead, log.name);
  PrintPrediction(report);
  for (const std::string& sentence :
       {NoIntervalSentence(report), GearSentence(report), BeyondTheLogSentence(report)}) {
    if (!sentence.empty()) PrintText(stdout, sentence + "\n");
  }
  for (const std::string& sentence : report.sentences) PrintText(stdout, sentence + "\n");
  if (!FLAGS_out.empty()) WriteFile(FLAGS_out, ManoeuvreCsv(report));
  if (!FLAGS_report.empty()) {
    Page page = ManoeuvrePage(report, FLAGS_manoeuvre, log.name);
    page.origin = OriginOfPage({log});
    WriteFile(FLAGS_report, RenderPage(page));
  }
  return kExitUsable;
}

int RunCoupledModel(const FittedCoupledModel& fitted) {
  if (DofFromFlag()) {
    throw InputError(
        fmt::format("--dof: is given, but {} is a model of several DOFs: expected no "
                    "--dof.",
                    FLAGS_model));
  }
  if (FLAGS_keep_run_effects) {
    throw InputError(
        fmt::format("--keep_run_effects: {} is a model of several DOFs, which knows the current of "
                    "each run by its log: expected none.",
                    FLAGS_model));
  }
  if (!(FLAGS_horizon > 0.0)) {
    throw InputError(fmt::format("--horizon: is {}, expected more than 0 s.", FLAGS_horizon));
  }
  const bool is_over_log = FLAGS_manoeuvre.empty() && FLAGS_table.empty();
  const std::vector<Log> logs = ReadCoupledLogsFromFlags(/*may_lack_motion=*/is_over_log);
  RequireOneLogForOut(logs.size());
  if (!is_over_log) {
    if (std::isfinite(FLAGS_horizon)) {
      throw InputError(
          "--horizon: begins the run over a log anew, expected none beside --manoeuvre or "
          "--table.");
    }
    if (logs.size() > 1) {
      throw InputError(
          "--manoeuvre, --table: begin as one log goes, expected a single --log with them.");
    }
    return RunManoeuvreOf(fitted, logs.front());
  }
  std::vector<CoupledScore> scores;
  bool all_run = true;
  for (const Log& log : logs) {
    PrintWarnings(CheckLogs({&log, 1}, fitted.model.dofs));
    const CoupledScore& score = scores.emplace_back(ScoreCoupled(fitted, log, FLAGS_horizon));
    if (logs.size() > 1) fmt::print("{}\n", log.path.string());
    if (score.prediction) {
      PrintText(stdout, CoupledScoreText(score, FLAGS_horizon));
    } else {
      std::fflush(stdout);
      fmt::print(stderr,
                 "fathom_simulate: the simulation of {} over {} diverges. --horizon begins it "
                 "anew.\n",
                 FLAGS_model,
                 log.path.string());
      all_run = false;
    }
    PrintRemarks(score.data.remarks);
  }
  for (const std::string& caveat : fitted.caveats) {
    PrintRemarks({"Said when the model was fitted: " + caveat});
  }
  if (!all_run) return 2;
  if (!FLAGS_json.empty()) WriteFile(FLAGS_json, CoupledScoresJson(scores, FLAGS_horizon));
  if (!FLAGS_out.empty()) WriteFile(FLAGS_out, CoupledPredictionCsv(scores.front()));
  return 0;
}

int Run() {
  RequireFlag("model", FLAGS_model, "a model or verdict file");
  RequireFlag("log", FLAGS_log, "a log folder or a CSV file");
  std::vector<std::string> inputs = InputsFromFlags();
  inputs.push_back(FLAGS_model);
  RequireOutputs({{"out", FLAGS_out}, {"json", FLAGS_json}, {"report", FLAGS_report}}, inputs);
  if (!FLAGS_report.empty() && FLAGS_manoeuvre.empty()) {
    throw InputError("--report: is a page of --manoeuvre, expected one beside it.");
  }
  if (!std::isnan(FLAGS_rudder_delay) && FLAGS_manoeuvre.empty()) {
    throw InputError("--rudder_delay: goes with --manoeuvre=zigzag:10/10, expected none.");
  }
  if (const std::string text = ReadFile(FLAGS_model); IsCoupledModel(text)) {
    return RunCoupledModel(ParseCoupledModel(FLAGS_model, text));
  }
  if (!FLAGS_manoeuvre.empty() || !FLAGS_table.empty()) {
    throw InputError(
        fmt::format("{}: goes with a model of several DOFs, expected none: {} is of one.",
                    FLAGS_table.empty() ? "--manoeuvre" : "--table",
                    FLAGS_model));
  }
  if (std::isfinite(FLAGS_horizon)) {
    throw InputError(
        fmt::format("--horizon: goes with a model of several DOFs, expected none: {} is "
                    "of one.",
                    FLAGS_model));
  }
  const FittedModel fitted = ReadModel(FLAGS_model);
  RequireDofOf(fitted);
  const std::vector<Log> logs = ReadLogsFromFlags(fitted.dof, /*may_lack_motion=*/true);
  RequireOneLogForOut(logs.size());
  std::vector<LogScore> scores;
  for (const Log& log : logs) {
    LogScore& score = scores.emplace_back(ScoreLog(fitted, log, FLAGS_keep_run_effects));
    PrintWarnings(score.findings);
    if (logs.size() > 1) fmt::print("{}\n", log.path.string());
    Print(score, log, fitted);
  }
  PrintRemarks(RemarksOfFile(fitted));
  const auto num_failed = std::count_if(
      scores.begin(), scores.end(), [](const LogScore& score) { return !score.prediction; });
  const bool is_usable = num_failed < std::ssize(scores);
  if (is_usable && !FLAGS_json.empty()) WriteFile(FLAGS_json, LogScoresJson(scores, fitted));
  if (is_usable && !FLAGS_out.empty()) {
    WriteFile(FLAGS_out, PredictionCsv(*scores.front().prediction, fitted.dof));
  }
  return num_failed == 0 ? 0 : 2;
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) { return fathom::RunTool(argc, argv, fathom::kInfo, fathom::Run); }
