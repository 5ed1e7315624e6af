// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/findings/finding.h"
#include "fathom/log/log.h"
#include "fathom/simulate/log_prediction.h"
#include "fathom/vehicle/fitted_model.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fathom {

// What a model of one DOF predicts for one log.
struct LogScore {
  std::string log;  // its name
  std::vector<Finding> findings;
  std::optional<LogPrediction> prediction;  // nothing if the simulation diverges
  std::vector<std::string> remarks;
  bool is_trained_on_it = false;  // the model
};

// Free runs over the log's command, with what every tool checks. Effects of another run than the
// log's are left out, unless `keep_run_effects`. Throws InputError as PredictLog() does.
LogScore ScoreLog(const FittedModel& fitted, const Log& log, bool keep_run_effects);

// The figures of a log, a line for each part of it. `score` holds a prediction.
std::string LogScoreText(const LogScore& score, const Log& log, const FittedModel& model);

// What the model file says of the model, which holds for every log.
std::vector<std::string> RemarksOfFile(const FittedModel& model);

// t and the predicted velocity at the stamps of all segments, CSV.
std::string PredictionCsv(const LogPrediction& prediction, Dof dof);

// Of one log its score, schema "fathom-score-1"; of several "fathom-scores-1".
std::string LogScoresJson(std::span<const LogScore> scores, const FittedModel& model);

}  // namespace fathom
