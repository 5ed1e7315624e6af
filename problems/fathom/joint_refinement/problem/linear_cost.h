// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/joint_refinement/processes/process_set.h"

#include <memory>
#include <vector>

namespace ceres {
class CostFunction;
}

namespace fathom {

// The costs of the joint problem that are linear in their blocks. `moving`: the coordinates that
// have deviations n and rates n' of their own, side by side in the blocks; docs/joint_refinement.md
// (4), (5).

// Of the excited coordinate's first deviation, whose start is among the globals. [m], [m/s], [rad]
// or [rad/s]
inline constexpr double kStartStd = 1e-6;

// From one frame to the next: W (s' - Phi s), rows two by two by coordinate; blocks n, n', next n,
// next n'.
std::unique_ptr<ceres::CostFunction> MakeStepCost(const ProcessSet& processes,
                                                  int excited,
                                                  const std::vector<int>& moving,
                                                  double duration);

// At a segment's first frame; blocks n, n'.
std::unique_ptr<ceres::CostFunction> MakeFirstCost(const ProcessSet& processes,
                                                   int excited,
                                                   const std::vector<int>& moving);

// (x - mean) / std of those entries of a block whose std is above 0 and finite; null if there is
// none.
std::unique_ptr<ceres::CostFunction> MakePriorCost(const std::vector<double>& std,
                                                   const std::vector<double>& mean);

}  // namespace fathom
