// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/joint_refinement/input.h"
#include "fathom/joint_refinement/motion/linear_segment.h"
#include "fathom/joint_refinement/options.h"
#include "fathom/joint_refinement/search/joint_search.h"
#include "fathom/joint_refinement/search/joint_start.h"
#include "fathom/joint_refinement/summary.h"

#include <span>
#include <string>
#include <vector>

namespace fathom {

// What must be known beyond the intervals of a refinement, a sentence each: what this log does not
// determine, what a delay of the command would change, how far the motion goes off its axis, what
// did not settle. `linear`: the segments about the search's end.
std::vector<std::string> CaveatsOn(const JointInput& input,
                                   const JointOptions& options,
                                   const JointStart& at,
                                   const SearchEnd& end,
                                   std::span<const LinearSegment> linear,
                                   const JointSummary& summary);

}  // namespace fathom
