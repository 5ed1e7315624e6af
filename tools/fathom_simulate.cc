// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// What a model predicts for a log: a free run over its command, scored against its measurement.

#include "fathom/base/exit_code.h"
#include "fathom/base/files/input_file.h"
#include "fathom/base/files/output_file.h"
#include "fathom/base/input_error.h"
#include "fathom/findings/finding_json.h"
#include "fathom/findings/inertia_check.h"
#include "fathom/findings/log_check.h"
#include "fathom/findings/prediction_check.h"
#include "fathom/signal/sources/choose_source.h"
#include "fathom/signal/sources/log_column.h"
#include "fathom/signal/split_at_gaps.h"
#include "fathom/simulate/log_prediction.h"
#include "fathom/simulate/model_for_log.h"
#include "fathom/simulate/prediction_remarks.h"
#include "fathom/tool/coupled_scores.h"
#include "fathom/tool/dof_flag.h"
#include "fathom/tool/log_flags.h"
#include "fathom/tool/manoeuvre_report.h"
#include "fathom/tool/output_flags.h"
#include "fathom/tool/print_findings.h"
#include "fathom/tool/print_text.h"
#include "fathom/tool/tool.h"
#include "fathom/vehicle/files/coupled_model_file.h"
#include "fathom/vehicle/files/figures_entry.h"
#include "fathom/vehicle/files/model_file.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gflags/gflags.h>
#include <nlohmann/json.hpp>

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

DEFINE_string(manoeuvre,
              "",
              "Of a model of several DOFs that steers with a rudder: turning_circle:35 or "
              "zigzag:10/10, in degrees.");
DEFINE_int32(draws, 200, "Of --manoeuvre: models drawn for its intervals.");
DEFINE_uint64(seed, 1, "Of --manoeuvre: seed of these draws.");

namespace fathom {
namespace {

using Json = nlohmann::ordered_json;

const ToolInfo kInfo = {
    "fathom_simulate",
    "Predicts a log's velocity by simulating from its command alone, and scores the prediction.",
    "--model=FILE --log=LOG [--log=LOG ...] [--dof=DOF] [--velocity=FILE] [--out=FILE] "
    "[--json=FILE] [--keep_run_effects] [--horizon=SECONDS]\n"
    "--model=FILE --log=LOG --manoeuvre=MANOEUVRE [--out=TRACK]",
    "fathom_simulate --model=surge.json --log=data/flatfish --out=prediction.csv",
    "The prediction is at the stamps of the log's motion stream, or of its command if there is "
    "none. It starts where the model fits the first two seconds best, and anew after a gap of "
    "over 30 s and at the ends of held-out intervals. A verdict of "
    "fathom_diagnose is simulated with its causes, as the sensor would show it. The motion of "
    "other DOFs is taken from the log. Causes of a run are left out on any other log. "
    "Several logs, as --log=A --log=B or --log=A,B, are scored one by one. A model of several "
    "degrees of freedom (fathom_identify --dofs) is simulated as one; --horizon begins its runs "
    "anew: docs/coupled.md. --manoeuvre plays a turning circle or a zigzag, from the log's first "
    "speed under its mean force: docs/fins.md.",
    {"log"}};

// t and the predicted velocity at the stamps of all segments.
std::string FormatPrediction(const LogPrediction& prediction, Dof dof) {
  std::string csv = fmt::format("t,{}\n", VelocityColumn(dof));
  for (size_t k = 0; k < prediction.segments.size(); ++k) {
    const std::vector<double>& time = prediction.segments[k].time;
    for (size_t i = 0; i < time.size(); ++i) {
      csv += fmt::format("{},{}\n", time[i], prediction.velocity[k][i]);
    }
  }
  return csv;
}

// `part`: ", held out" of a log, ", another log", or nothing.
void PrintFigures(const char* part, const FitFigures& figures, Dof dof) {
  if (figures.num_samples == 0) return;
  fmt::print("{}{}: velocity MAE {:.5f} {}, velocity NMAE {} over {} samples, {:.0f} s\n",
             Name(dof),
             part,
             figures.mae,
             VelocityUnit(dof),
             std::isfinite(figures.nmae) ? fmt::format("{:.4f}", figures.nmae) : "-",
             figures.num_samples,
             figures.duration);
}

// Another log than the model's is not split: the model has seen nothing of it. A model that does
// not name its logs leaves open which one this is.
void PrintFigures(const LogPrediction& prediction,
                  const Log& log,
                  const FittedModel& model,
                  bool is_trained_on_it) {
  const Dof dof = model.dof;
  if (!std::isfinite(prediction.figures.mae)) {
    fmt::print(
        "{}: predicted from rest. The log has no column '{}' and no pose to score the "
        "prediction{}\n",
        Name(dof),
        VelocityColumn(dof),
        log.detections ? ". fathom_track makes poses from its detections.csv." : "");
    return;
  }
  const bool is_another = !is_trained_on_it && !model.log_fingerprints.empty();
  if (is_another || log.held_out.empty()) {
    PrintFigures(is_another ? ", another log" : "", prediction.figures, dof);
    return;
  }
  PrintFigures(is_trained_on_it ? ", training data" : ", not held out", prediction.train, dof);
  PrintFigures(", held out", prediction.held_out, dof);
}

// What became of one log.
struct LogScore {
  std::string log;  // its name
  std::vector<Finding> findings;
  std::optional<LogPrediction> prediction;  // nothing if the simulation diverges
  std::vector<std::string> remarks;
  bool is_trained_on_it = false;  // the model
};

// What every tool checks, where the log measures the motion; the model against the vehicle, and the
// prediction against the log.
std::vector<Finding> FindingsOn(const Log& log,
                                const FittedModel& model,
                                const std::optional<LogPrediction>& prediction) {
  std::vector<Finding> findings;
  if (!SourcesOf(log, model.dof).empty()) findings = CheckLogs({&log, 1}, model.dof);
  if (auto finding = CheckInertia(model, BodyOf({&log, 1}))) {
    findings.push_back(*std::move(finding));
  }
  if (auto finding = CheckPrediction(prediction, model.dof)) {
    findings.push_back(*std::move(finding));
  }
  return WarningsFirst(std::move(findings));
}

LogScore ScoreOf(const FittedModel& fitted, const Log& log) {
  const auto [model, left_out, is_trained_on_it] =
      RestrictToLog(fitted, log, FLAGS_keep_run_effects);
  LogScore score = {log.name, {}, PredictLog(model, log), {}, is_trained_on_it};
  score.findings = FindingsOn(log, model, score.prediction);
  if (!score.prediction) return score;
  score.remarks = RemarksOn(model, *score.prediction);
  const std::vector<double>& last = score.prediction->segments.back().time;
  std::string early_end = RemarkOnEarlyEnd(CommandOf(log, model.dof), last, kLongestGap);
  if (!early_end.empty()) score.remarks.push_back(std::move(early_end));
  if (!left_out.empty()) {
    score.remarks.push_back(
        fmt::format("left out: {}. Effects of the run that the model was identified from need not "
                    "hold in another one. --keep_run_effects keeps them.",
                    fmt::join(left_out, ", ")));
  }
  return score;
}

// What the model file says of the model, which holds for every log.
std::vector<std::string> RemarksOfFile(const FittedModel& model) {
  std::vector<std::string> remarks;
  for (const std::string& caveat : model.caveats) {
    remarks.push_back("Said when the model was fitted: " + caveat);
  }
  return remarks;
}

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
  PrintFigures(*score.prediction, log, model, score.is_trained_on_it);
  PrintRemarks(score.remarks);
}

// Schema "fathom-score-1"; docs/file_formats.md. A number that is not known is null.
Json FormatScore(const LogScore& score, const FittedModel& model) {
  std::vector<std::string> remarks = score.remarks;
  std::ranges::move(RemarksOfFile(model), std::back_inserter(remarks));
  const LogPrediction prediction = score.prediction.value_or(LogPrediction());
  const FitFigures& figures = prediction.figures;
  return {{"schema", "fathom-score-1"},
          {"log", score.log},
          {"dof", Name(model.dof)},
          {"mae", figures.mae},
          {"nmae", figures.nmae},
          {"n", figures.num_samples},
          {"duration", figures.duration},
          {"train", JsonOfFigures<Json>(prediction.train)},
          {"held_out", JsonOfFigures<Json>(prediction.held_out)},
          {"findings", JsonOf<Json>(score.findings)},
          {"remarks", remarks}};
}

// Of one log its score; of several "fathom-scores-1".
std::string FormatScores(const std::vector<LogScore>& scores, const FittedModel& model) {
  Json json;
  if (scores.size() == 1) {
    json = FormatScore(scores.front(), model);
  } else {
    json = {{"schema", "fathom-scores-1"}, {"scores", Json::array()}};
    for (const LogScore& score : scores) json["scores"].push_back(FormatScore(score, model));
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
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

int RunManoeuvreOf(const FittedCoupledModel& fitted, const Log& log) {
  if (FLAGS_draws < 0) {
    throw InputError(fmt::format("--draws: is {}, expected 0 or more.", FLAGS_draws));
  }
  const Manoeuvre manoeuvre = ParseManoeuvre(FLAGS_manoeuvre);
  const ManoeuvreReport report = ReportManoeuvre(fitted, log, manoeuvre, FLAGS_draws, FLAGS_seed);
  fmt::print("{} from {:.3g} m/s, the rudder at most at {:.3g} rad/s, as in {}:\n",
             FLAGS_manoeuvre,
             report.ahead,
             report.rudder_rate,
             log.name);
  PrintText(stdout, FormatTable(ManoeuvreTable(report)));
  if (report.num_astray > 0) {
    fmt::print("note: {} of {} drawn models cannot be or diverge; the intervals are of the rest.\n",
               report.num_astray,
               report.num_draws);
  }
  if (!FLAGS_out.empty()) WriteFile(FLAGS_out, ManoeuvreCsv(report));
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
    throw InputError(fmt::format(
        "--keep_run_effects: {} is a model of several DOFs, which has no effects: expected none.",
        FLAGS_model));
  }
  if (!(FLAGS_horizon > 0.0)) {
    throw InputError(fmt::format("--horizon: is {}, expected more than 0 s.", FLAGS_horizon));
  }
  const std::vector<Log> logs = ReadLogsFromFlags({});
  RequireOneLogForOut(logs.size());
  if (!FLAGS_manoeuvre.empty()) {
    if (logs.size() > 1) {
      throw InputError("--manoeuvre: begins as one log goes, expected a single --log with it.");
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
  RequireOutputs({{"out", FLAGS_out}, {"json", FLAGS_json}}, inputs);
  if (const std::string text = ReadFile(FLAGS_model); IsCoupledModel(text)) {
    return RunCoupledModel(ParseCoupledModel(FLAGS_model, text));
  }
  if (!FLAGS_manoeuvre.empty()) {
    throw InputError(
        fmt::format("--manoeuvre: goes with a model of several DOFs, expected none: {} is of one.",
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
    LogScore& score = scores.emplace_back(ScoreOf(fitted, log));
    PrintWarnings(score.findings);
    if (logs.size() > 1) fmt::print("{}\n", log.path.string());
    Print(score, log, fitted);
  }
  PrintRemarks(RemarksOfFile(fitted));
  const auto num_failed = std::count_if(
      scores.begin(), scores.end(), [](const LogScore& score) { return !score.prediction; });
  const bool is_usable = num_failed < std::ssize(scores);
  if (is_usable && !FLAGS_json.empty()) WriteFile(FLAGS_json, FormatScores(scores, fitted));
  if (is_usable && !FLAGS_out.empty()) {
    WriteFile(FLAGS_out, FormatPrediction(*scores.front().prediction, fitted.dof));
  }
  return num_failed == 0 ? 0 : 2;
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) { return fathom::RunTool(argc, argv, fathom::kInfo, fathom::Run); }
