// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/log.h"
#include "fathom/simulate/coupled/coupled_data.h"
#include "fathom/simulate/coupled/coupled_prediction.h"
#include "fathom/vehicle/coupled/fitted_coupled_model.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fathom {

// What a model of several DOFs predicts for one log.
struct CoupledScore {
  std::string log;  // its name
  CoupledData data;
  std::optional<CoupledPrediction> prediction;  // nothing if a run diverges
  bool is_trained_on_it = false;
};

// Free runs begun anew from the measured state every `horizon` [s]. Throws InputError as
// CoupledDataOf() does, and for a log in another unit of force than the model's.
CoupledScore ScoreCoupled(const FittedCoupledModel& fitted, const Log& log, double horizon);

// The figures of a log, a line for each DOF.
std::string CoupledScoreText(const CoupledScore& score, double horizon);

// t and the predicted velocities of the modelled DOFs, CSV.
std::string CoupledPredictionCsv(const CoupledScore& score);

// Of one log its score, schema "fathom-coupled-score-1"; of several a list of them.
std::string CoupledScoresJson(std::span<const CoupledScore> scores, double horizon);

}  // namespace fathom
