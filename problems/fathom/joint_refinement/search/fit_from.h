// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/joint_refinement/input.h"
#include "fathom/joint_refinement/options.h"
#include "fathom/joint_refinement/search/joint_start.h"
#include "fathom/joint_refinement/summary.h"

namespace fathom {

// The joint problem searched from one start, every segment in a frame of its own, which follows
// the poses as the search makes them better.
JointSummary FitFrom(const JointInput& input, const JointOptions& options, StartPoses start);

}  // namespace fathom
