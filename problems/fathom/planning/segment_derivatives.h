// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/planning/planned_motion.h"
#include "fathom/signal/segment.h"

#include <optional>
#include <vector>

namespace fathom {

// A model's run over a measured segment, from the start that fits it best, at the segment's stamps.
struct SegmentRun {
  PlannedMotion motion;
  // What belongs to one run, as a current does, stands among the columns of the start; its columns
  // among the parameters are 0.
  MotionDerivatives derivatives;
};

// Nothing if the run diverges. No effect may need a partner.
std::optional<SegmentRun> RunOver(const Segment& segment, const ExtendedModel& model, Dof dof);

// True for each parameter that belongs to one run, in the order of FittedModel::covariance.
std::vector<bool> AreOfRun(const ExtendedModel& model);

}  // namespace fathom
