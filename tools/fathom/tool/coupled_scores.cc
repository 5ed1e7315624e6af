// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/coupled_scores.h"

#include "fathom/base/files/json_text.h"
#include "fathom/base/input_error.h"
#include "fathom/log/log_fingerprint.h"
#include "fathom/tool/score_line.h"
#include "fathom/vehicle/files/figures_entry.h"
#include "fathom/vehicle/files/thruster_shares.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ranges>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using Json = nlohmann::ordered_json;

Json JsonOf(const CoupledScore& score, double horizon) {
  Json dofs = Json::object();
  const CoupledPrediction prediction = score.prediction.value_or(CoupledPrediction());
  for (const Dof dof : score.data.dofs) {
    const auto at = static_cast<std::size_t>(Index(dof));
    Json of = JsonOfFigures<Json>(prediction.figures[at]);
    of["train"] = JsonOfFigures<Json>(prediction.train[at]);
    of["held_out"] = JsonOfFigures<Json>(prediction.held_out[at]);
    dofs[std::string(Name(dof))] = of;
  }
  return {{"schema", "fathom-coupled-score-1"},
          {"log", score.log},
          {"horizon", std::isfinite(horizon) ? Json(horizon) : Json()},
          {"dofs", dofs},
          {"position_error_10_s", prediction.position_error},
          {"remarks", score.data.remarks}};
}

}  // namespace

CoupledScore ScoreCoupled(const FittedCoupledModel& fitted, const Log& log, double horizon) {
  CoupledScore score;
  score.log = log.name;
  const std::optional<Vehicle> vehicle = VehicleOf(log);
  const Vehicle of_log = vehicle.value_or(Vehicle());
  score.data = CoupledDataOf(log, fitted.model.dofs, of_log.thrusters, of_log.fins, of_log.shafts);
  if (score.data.force_unit != fitted.force_unit) {
    throw InputError(fmt::format("{}: is commanded in {}, expected {}, the unit of the model.",
                                 log.path.string(),
                                 score.data.force_unit,
                                 fitted.force_unit));
  }
  const std::vector<std::string>& known = fitted.log_fingerprints;
  score.is_trained_on_it = std::find(known.begin(), known.end(), FingerprintOf(log)) != known.end();
  if (!fitted.model.current.empty() && !fitted.model.current.contains(log.name)) {
    score.data.remarks.push_back(fmt::format(
        "The model knows the current of {}, not of this log, which is simulated in still water.",
        fmt::join(std::views::keys(fitted.model.current), ", ")));
  }
  if (!score.is_trained_on_it && !fitted.model.run_offset.empty()) {
    score.data.remarks.push_back(
        fmt::format("The model knows offsets of {} alone. This log may have one as large, which is "
                    "not foreseen.",
                    fmt::join(std::views::keys(fitted.model.run_offset), ", ")));
  }
  score.prediction = PredictCoupled(fitted.model, {&score.data, 1}, horizon);
  return score;
}

std::string CoupledScoreText(const CoupledScore& score, double horizon) {
  std::string text =
      std::isfinite(horizon)
          ? fmt::format("Free runs, begun anew from the measured state every {:g} s:\n", horizon)
          : std::string("Free runs, one for each stretch of the log:\n");
  for (const Dof dof : score.data.dofs) {
    const auto at = static_cast<std::size_t>(Index(dof));
    const CoupledPrediction& prediction = *score.prediction;
    if (prediction.figures[at].num_samples == 0) continue;  // not measured
    if (!score.is_trained_on_it) {
      text += ScoreLine(", another log", prediction.figures[at], dof);
      continue;
    }
    text += ScoreLine(", training data", prediction.train[at], dof);
    text += ScoreLine(", held out", prediction.held_out[at], dof);
  }
  if (std::isfinite(score.prediction->position_error)) {
    text += fmt::format("position 10 s after a start: off by {:.3g} m (RMS)\n",
                        score.prediction->position_error);
  }
  return text;
}

std::string CoupledPredictionCsv(const CoupledScore& score) {
  std::string csv = "t";
  for (const Dof dof : score.data.dofs) csv += fmt::format(",{}", VelocityColumn(dof));
  csv += "\n";
  for (std::size_t s = 0; s < score.data.segments.size(); ++s) {
    const std::vector<double>& time = score.data.segments[s].time;
    for (std::size_t i = 0; i < time.size(); ++i) {
      csv += fmt::format("{}", time[i]);
      for (const Dof dof : score.data.dofs) {
        csv += fmt::format(",{}", score.prediction->velocity.front()[s][i][Index(dof)]);
      }
      csv += "\n";
    }
  }
  return csv;
}

std::string CoupledScoresJson(std::span<const CoupledScore> scores, double horizon) {
  Json json;
  if (scores.size() == 1) {
    json = JsonOf(scores.front(), horizon);
  } else {
    json = {{"schema", "fathom-coupled-scores-1"}, {"scores", Json::array()}};
    for (const CoupledScore& score : scores) json["scores"].push_back(JsonOf(score, horizon));
  }
  return JsonText(json);
}

}  // namespace fathom
