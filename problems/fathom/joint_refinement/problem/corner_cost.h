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

// Reprojection of one detection, whitened. Blocks: deviation of the frame (if any coordinate
// moves), model, start, response, and the clock if it is free. Borrows all but the numbers.
struct CornerCostOf {
  const JointData& data;
  const MotionCallback& motions;
  const std::vector<int>& moving;  // the coordinates with deviations
  const JointUnknowns& unknowns;
  double corner_sigma;  // [px]
  size_t segment, frame;
  const Detection& detection;
  bool with_clock;
};

std::unique_ptr<ceres::CostFunction> MakeCornerCost(const CornerCostOf& of);

}  // namespace fathom
