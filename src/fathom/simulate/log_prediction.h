// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/log.h"
#include "fathom/signal/segment.h"
#include "fathom/vehicle/fitted_model.h"

#include <optional>
#include <vector>

namespace fathom {

// What a model predicts for a whole log, held-out intervals and all.
struct LogPrediction {
  // At every stamp of the log's motion stream, or, without one, of its command, with a "measured"
  // velocity of NaN but for the start from rest.
  std::vector<Segment> segments;

  // Of each segment, at its stamps: as the velocity sensor would show it [m/s] or [rad/s].
  std::vector<std::vector<double>> velocity;

  FitFigures figures;  // NaN where the log does not measure the motion
};

// Free runs of `model` over the segments of `log`, each started from its first measured speed. An
// effect acts in the log whatever run it belongs to: RestrictToLog() comes before.
//
// Nothing if a run diverges. Throws InputError if the log was commanded in another unit than the
// model's, has no command along its DOF, or lacks the partner of an effect.
std::optional<LogPrediction> PredictLog(const FittedModel& model, const Log& log);

}  // namespace fathom
