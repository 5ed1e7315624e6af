// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/log_scores.h"

#include "fathom/base/files/json_text.h"
#include "fathom/base/input_error.h"
#include "fathom/findings/finding_json.h"
#include "fathom/findings/inertia_check.h"
#include "fathom/findings/log_check.h"
#include "fathom/findings/prediction_check.h"
#include "fathom/signal/signals.h"
#include "fathom/signal/sources/choose_source.h"
#include "fathom/signal/sources/log_column.h"
#include "fathom/signal/split_at_gaps.h"
#include "fathom/simulate/model_for_log.h"
#include "fathom/simulate/prediction_remarks.h"
#include "fathom/tool/score_line.h"
#include "fathom/vehicle/files/figures_entry.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using Json = nlohmann::ordered_json;

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

}  // namespace

LogScore ScoreLog(const FittedModel& fitted, const Log& log, bool keep_run_effects) {
  const auto [model, left_out, is_trained_on_it] = RestrictToLog(fitted, log, keep_run_effects);
  LogScore score = {log.name, {}, PredictLog(model, log), {}, is_trained_on_it};
  if (score.prediction && score.prediction->segments.empty()) {
    throw InputError(fmt::format(
        "{}: no stretch of its motion has {} samples without a gap of over {:g} s, expected one.",
        log.path.string(),
        kFewestOfSegment,
        kLongestGap));
  }
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

// Another log than the model's is not split: the model has seen nothing of it. A model that does
// not name its logs leaves open which one this is.
std::string LogScoreText(const LogScore& score, const Log& log, const FittedModel& model) {
  const LogPrediction& prediction = *score.prediction;
  const Dof dof = model.dof;
  if (!std::isfinite(prediction.figures.mae)) {
    return fmt::format(
        "{}: predicted from rest. The log has no column '{}' and no pose to score the "
        "prediction{}\n",
        Name(dof),
        VelocityColumn(dof),
        log.detections ? ". fathom_track makes poses from its detections.csv." : "");
  }
  const bool is_another = !score.is_trained_on_it && !model.log_fingerprints.empty();
  if (is_another || log.held_out.empty()) {
    return ScoreLine(is_another ? ", another log" : "", prediction.figures, dof);
  }
  const char* const part = score.is_trained_on_it ? ", training data" : ", not held out";
  return ScoreLine(part, prediction.train, dof) + ScoreLine(", held out", prediction.held_out, dof);
}

std::vector<std::string> RemarksOfFile(const FittedModel& model) {
  std::vector<std::string> remarks;
  for (const std::string& caveat : model.caveats) {
    remarks.push_back("Said when the model was fitted: " + caveat);
  }
  return remarks;
}

std::string PredictionCsv(const LogPrediction& prediction, Dof dof) {
  std::string csv = fmt::format("t,{}\n", VelocityColumn(dof));
  for (size_t k = 0; k < prediction.segments.size(); ++k) {
    const std::vector<double>& time = prediction.segments[k].time;
    for (size_t i = 0; i < time.size(); ++i) {
      csv += fmt::format("{},{}\n", time[i], prediction.velocity[k][i]);
    }
  }
  return csv;
}

std::string LogScoresJson(std::span<const LogScore> scores, const FittedModel& model) {
  Json json;
  if (scores.size() == 1) {
    json = FormatScore(scores.front(), model);
  } else {
    json = {{"schema", "fathom-scores-1"}, {"scores", Json::array()}};
    for (const LogScore& score : scores) json["scores"].push_back(FormatScore(score, model));
  }
  return JsonText(json);
}

}  // namespace fathom
