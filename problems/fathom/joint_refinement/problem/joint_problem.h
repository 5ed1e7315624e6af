// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/joint_refinement/problem/joint_state.h"
#include "fathom/joint_refinement/problem/linear_joint.h"
#include "fathom/solve/solve_with_bounds.h"

#include <vector>

namespace fathom {

struct JointSolveOptions {
  int max_iterations = 50;
  bool without_model = false;  // plain bundle adjustment of the same poses, to compare with
};

// The one Ceres problem: every pose, the model, the starts, the responses and the clocks, over all
// corners, under given processes and with the setup as it is (FitMarkerSizeAndMount() moves that).
// Dampings stay at least 0; one that `priors` hold stays where it is. `held` of the result are the
// dampings on their bound, as kQuadraticDamping and kLinearDamping.
//
// Of `priors`, which are as in LinearJoint with their offsets at the present unknowns, the clock's
// count, and which dampings they hold.
BoundedSolve SolveJoint(JointData* data,
                        const ProcessSet& processes,
                        const std::vector<GlobalsPrior>& priors,
                        const JointSolveOptions& options,
                        JointUnknowns* unknowns);

}  // namespace fathom
