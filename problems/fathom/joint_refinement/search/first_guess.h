// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/joint_refinement/input.h"
#include "fathom/joint_refinement/motion/pose_chart.h"
#include "fathom/vehicle/uncoupled_model.h"

#include <span>
#include <vector>

namespace fathom {

// First guesses of a segment's poses frame_from_body in the chart, angles unwrapped, each
// coordinate the median of the frames around: what flips or flies off for a few frames is gone, and
// a steady motion stays.
std::vector<PoseVector> SteadyPoses(std::span<const Pose> frame_from_body);

// Where the search starts: output error on the displacement of the steady poses.
UncoupledModel<double> FirstModel(const JointInput& input,
                                  const std::vector<std::vector<PoseVector>>& steady);

}  // namespace fathom
