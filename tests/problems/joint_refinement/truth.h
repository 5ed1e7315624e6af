// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/joint_refinement/problem/joint_problem.h"
#include "fathom/joint_refinement/problem/joint_state.h"

#include "camera_experiment.h"

namespace fathom {

// The joint problem of a synthetic run with every unknown at its truth.
struct Truth {
  JointData data;
  JointUnknowns unknowns;
};

Truth TruthOf(const SyntheticCameraRun& run);

}  // namespace fathom
