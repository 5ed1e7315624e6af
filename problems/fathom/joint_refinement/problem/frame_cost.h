// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/joint_refinement/problem/joint_state.h"
#include "fathom/joint_refinement/problem/motion_callback.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace ceres {
class CostFunction;
}

namespace fathom {

// Reprojection of a frame's detections, whitened, with their loss (7). Blocks: deviation of the
// frame (if any coordinate moves), model, start, response, and the clock if it is free. Borrows all
// but the numbers. At least one detection.
//
// All corners depend on the unknowns through the frame's pose alone. With r their residuals and
// J_p = Q R the derivatives by the pose, both weighted by the root of the loss's slope, seven rows
// say to Gauss and Newton what eight for each detection do:
//
//   rows 1 to 6   Q' r, with the derivatives R d eta / d unknowns
//   row 7         the root of what the loss of all detections is beyond their squares, held fixed
//
// Half the sum of squares, J'J and J'r are those of all corners. Without derivatives only the sum
// of squares is computed: all of it is then in row 7.
struct FrameCostOf {
  const JointData& data;
  const MotionCallback& motions;
  const std::vector<int>& moving;  // the coordinates with deviations
  const JointUnknowns& unknowns;
  double corner_sigma;  // [px]
  size_t segment, frame;
  bool with_clock;
};

std::unique_ptr<ceres::CostFunction> MakeFrameCost(const FrameCostOf& of);

}  // namespace fathom
