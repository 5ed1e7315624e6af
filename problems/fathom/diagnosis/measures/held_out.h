// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/data/measured_segments.h"
#include "fathom/simulate/free_run.h"
#include "fathom/vehicle/extended_model.h"

#include <optional>
#include <span>
#include <vector>

namespace fathom {

// The free run of a model over a segment, from FittedStart(); nothing if it diverges. Displacements
// where no velocity is measured.
std::optional<FreeRun> FreeRunOver(const MeasuredSegment& segment, const ExtendedModel& model);

// The same from a given start, as a fit ends with it.
std::optional<FreeRun> RunFrom(const InitialState& initial,
                               const MeasuredSegment& segment,
                               const ExtendedModel& model);

// The displacements of a run from such a state, where velocities and poses are measured: each block
// of 10 s put onto the straight line that was measured. A free run strays from its place by far
// more than what is wrong with poses moves them; how they move within a block shows it.
std::optional<FreeRun> PosesByBlock(const MeasuredSegment& segment, const ExtendedModel& model);

// Whether two sets of runs are over the same samples. A run that diverges is left out, and blocks
// may be left out of all logs together or of each.
bool AreOverTheSame(std::span<const FreeRun> a, std::span<const FreeRun> b);

// Free runs of two models over the same segments, which neither was fitted to.
struct Scored {
  std::vector<FreeRun> before, after;

  std::vector<FreeRun> poses_before, poses_after;  // by PosesByBlock()

  bool by_log = false;  // whole logs were left out: GainOverLogs()
};

// The runs of two models that were scored against the same third one: `before` of what stood,
// `after` of what is tried.
Scored Beside(const Scored& stood, const Scored& tried);

// The gain; of an effect that acts on the poses alone, which velocities know nothing of, in the
// poses, where there are both.
Gain GainOf(const Scored& scored, bool acts_on_poses_alone);

// The runs over the segments that both models can run over.
Scored Score(const std::vector<MeasuredSegment>& segments,
             const ExtendedModel& before,
             const ExtendedModel& after);

}  // namespace fathom
