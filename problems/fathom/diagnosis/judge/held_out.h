// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/data/measured_segments.h"
#include "fathom/vehicle/extended_model.h"
#include "fathom/vehicle/fitted_model.h"

#include <optional>
#include <span>
#include <vector>

namespace fathom {

// A free run beside what was measured, sample by sample.
struct FreeRun {
  std::vector<double> time;       // log time [s]
  std::vector<double> measured;   // velocity [m/s] or [rad/s]; displacement where there is none
  std::vector<double> predicted;  // the same
};

// The free run of a model over a segment, from the state whose run fits the first two seconds of
// what was measured (ten samples at least) best, in least squares; nothing if it diverges. Every
// model starts by this rule, each from a state of its own: what is measured is not the state, and a
// straight line through it is none where the motion turns within these seconds.
std::optional<FreeRun> FreeRunOver(const MeasuredSegment& segment, const ExtendedModel& model);

// The same from a given start.
std::optional<FreeRun> FreeRunOver(const MeasuredSegment& segment,
                                   const ExtendedModel& model,
                                   const InitialState& initial);

// The displacements of a run from such a state, where velocities and poses are measured: each block
// of 10 s put onto the straight line that was measured. A free run strays from its place by far
// more than what is wrong with poses moves them; how they move within a block shows it.
std::optional<FreeRun> PosesByBlock(const MeasuredSegment& segment, const ExtendedModel& model);

// MAE and NMAE over several runs together (docs/models.md (7), (8)); NaN if there are none.
FitFigures FiguresOfRuns(std::span<const FreeRun> runs);

// Whether two sets of runs are over the same samples. A run that diverges is left out, and blocks
// may be left out of all logs together or of each.
bool AreOverTheSame(std::span<const FreeRun> a, std::span<const FreeRun> b);

// How much less the second model's runs miss than the first's, over the same segments:
// 1 - sum |miss after| / sum |miss before|, with a 95 % interval from blocks of 10 s (of 5 s at
// least, where the runs are short), Student's for their number; NaN from fewer than four.
struct Gain {
  double value = 0.0, low = 0.0, high = 0.0;
  bool is_in_poses = false;  // Scored::poses_before and poses_after
};
Gain GainOf(std::span<const FreeRun> before, std::span<const FreeRun> after);

// Free runs of two models over the same segments, which neither was fitted to.
struct Scored {
  std::vector<FreeRun> before, after;

  std::vector<FreeRun> poses_before, poses_after;  // by PosesByBlock()
};

// The gain; of an effect that acts on the poses alone, which velocities know nothing of, in the
// poses, where there are both.
Gain GainOf(const Scored& scored, bool acts_on_poses_alone);

// The runs over the segments that both models can run over.
Scored Score(const std::vector<MeasuredSegment>& segments,
             const ExtendedModel& before,
             const ExtendedModel& after);

}  // namespace fathom
