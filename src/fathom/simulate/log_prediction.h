// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/log.h"
#include "fathom/signal/segment.h"
#include "fathom/vehicle/fitted_model.h"

#include <optional>
#include <vector>

namespace fathom {

// What part of a log a stretch of it is of.
enum class LogPart {
  kTrain,    // what a fit of this log takes
  kHeldOut,  // its held-out intervals
  kOutside,  // before the first command, and pieces too short to fit: in no figure
};

// What a model predicts for a whole log.
struct LogPrediction {
  // At every stamp of the log's motion stream, or, without one, of its command, in the order of
  // time. A measured velocity is NaN where the log has none.
  std::vector<Segment> segments;
  std::vector<LogPart> parts;  // of each segment

  // Of each segment, at its stamps: as the velocity sensor would show it [m/s] or [rad/s].
  std::vector<std::vector<double>> velocity;

  // NaN where the log does not measure the motion.
  FitFigures figures;  // of training and held-out data together
  FitFigures train, held_out;
};

// Free runs of `model` over `log`, each from FittedStart(), cut as SignalsOf() cuts: at silences of
// over 30 s and at the ends of held-out intervals. An effect acts in the log whatever run it
// belongs to: RestrictToLog() comes before.
//
// Nothing if a run diverges. Throws InputError if the log was commanded in another unit than the
// model's, has no command along its DOF, or lacks the partner of an effect.
std::optional<LogPrediction> PredictLog(const FittedModel& model, const Log& log);

}  // namespace fathom
