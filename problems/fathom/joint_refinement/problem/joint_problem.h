// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/joint_refinement/problem/joint_state.h"
#include "fathom/joint_refinement/problem/linear_joint.h"

#include <string>
#include <vector>

namespace fathom {

struct JointSolve {
  bool converged = false;
  std::string message;
  double initial_cost = 0.0;
  double cost = 0.0;
  int num_iterations = 0;
  double seconds_per_iteration = 0.0;
  std::vector<int> held_at_zero;  // dampings on their bound
};

struct JointSolveOptions {
  int max_iterations = 50;
  bool without_model = false;  // plain bundle adjustment of the same poses, to compare with
};

// The one Ceres problem: every pose, the model, the starts, the responses and the clocks, over all
// corners, under given processes and with the setup as it is (FitMarkerSizeAndMount() moves that).
// Dampings stay at least 0 by SearchActiveSet(), since Ceres' bounds report convergence at a wrong
// point when one is active; one that `priors` hold stays where it is.
//
// Of `priors`, which are as in LinearJoint with their offsets at the present unknowns, the clock's
// count, and which dampings they hold.
JointSolve SolveJoint(JointData* data,
                      const ProcessSet& processes,
                      const std::vector<GlobalsPrior>& priors,
                      const JointSolveOptions& options,
                      JointUnknowns* unknowns);

}  // namespace fathom
