// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/signal/segment.h"
#include "fathom/simulate/effect_inputs.h"
#include "fathom/vehicle/extended_model.h"
#include "fathom/vehicle/fitted_model.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fathom {

// A free run beside what was measured, sample by sample. The measurement enters only where the run
// starts: FittedStart().
struct FreeRun {
  std::vector<double> time;       // log time [s]
  std::vector<double> measured;   // velocity [m/s] or [rad/s]; displacement where there is none
  std::vector<double> predicted;  // the same
  std::string log = {};           // whose it is, where that matters
};

// The free run of a model over a segment, from FittedStart(): the one rule by which every tool
// scores a model. Velocities, as measured or derived from the poses. `inputs` may be null where the
// model has no effects; `position` as there. Nothing if the run diverges.
std::optional<FreeRun> FreeRunOver(const Segment& segment,
                                   const ExtendedModel& model,
                                   double position = 0.0,
                                   const EffectInputs* inputs = nullptr);

// MAE and NMAE over several runs together (docs/models.md (7), (8)); NaN if there are none.
FitFigures FiguresOfRuns(std::span<const FreeRun> runs);

// Of FreeRunOver() all segments, without effects; NaN if a run diverges.
FitFigures FiguresOf(const ExtendedModel& model, std::span<const Segment> segments);

// How much less the second model's runs miss than the first's, over the same segments:
// 1 - sum |miss after| / sum |miss before|, with a 95 % interval from blocks of 10 s (of 5 s at
// least, where the runs are short), Student's for their number, cut at 1; NaN from fewer than four.
struct Gain {
  double value = 0.0, low = 0.0, high = 0.0;
  bool is_in_poses = false;  // of displacements within 10 s instead

  // Where logs are counted: how many, and for how many the second model misses less.
  std::size_t num_logs = 0, num_better = 0;
};
Gain GainOf(std::span<const FreeRun> before, std::span<const FreeRun> after);

// The same where each log was left out as a whole: blocks of one run share what is special about
// it, so the interval counts logs. NaN from fewer than two.
Gain GainOverLogs(std::span<const FreeRun> before, std::span<const FreeRun> after);

}  // namespace fathom
