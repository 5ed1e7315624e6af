// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/joint_refinement/input.h"
#include "fathom/joint_refinement/options.h"
#include "fathom/joint_refinement/summary.h"

namespace fathom {

// The model, every camera pose, and what else is asked for, from the corners themselves:
// docs/joint_refinement.md. Throws InputError if the options or the input cannot be used. A poor
// fit does not throw: see the summary.
JointSummary FitJoint(const JointInput& input, const JointOptions& options = {});

}  // namespace fathom
