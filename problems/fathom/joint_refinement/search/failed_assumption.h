// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/joint_refinement/input.h"
#include "fathom/joint_refinement/options.h"

#include <string>

namespace fathom {

// The assumption that keeps a search from an end, in a sentence with what it would have to be: of
// those that the options hold (the camera's clock, the size of the markers), the first with which
// the search ends once it is free, and which then is off by more than four standard deviations.
// Empty if there is none. `reached_setup`: whether a search without an end came to where the size
// moves if it is free (JointSummary). Where none did, a free size would change nothing.
std::string FailedAssumption(const JointInput& input,
                             const JointOptions& options,
                             bool reached_setup);

}  // namespace fathom
