// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/joint_refinement/input.h"
#include "fathom/joint_refinement/options.h"
#include "fathom/joint_refinement/problem/joint_state.h"
#include "fathom/joint_refinement/processes/process_set.h"

#include <span>
#include <vector>

namespace fathom {

// Which poses a search starts from.
enum class StartPoses {
  kTracked,    // the frames' own, without flips and outliers of a few frames
  kHeldStill,  // the held coordinates at the medians of the frames' own, the excited one where the
               // first model takes it
};

// Where the search for the joint problem starts.
struct JointStart {
  JointData data;
  JointUnknowns unknowns;
  ProcessSet processes;
  MotionScales scales;
  StartPoses poses = StartPoses::kTracked;
};

// From poses frame_from_body of every segment, in its frame (segment_frame.h), and the model that
// the options give, or output error on the displacement of the poses.
JointStart StartOf(const JointInput& input,
                   const JointOptions& options,
                   StartPoses poses,
                   std::span<const Pose> world_from_frame,
                   std::span<const std::vector<Pose>> frame_from_body);

}  // namespace fathom
