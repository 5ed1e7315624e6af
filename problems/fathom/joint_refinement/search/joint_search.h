// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/joint_refinement/options.h"
#include "fathom/joint_refinement/problem/joint_state.h"
#include "fathom/joint_refinement/problem/linear_joint.h"
#include "fathom/joint_refinement/search/joint_start.h"
#include "fathom/joint_refinement/search/marker_size_and_mount.h"
#include "fathom/joint_refinement/summary.h"

#include <vector>

namespace fathom {

// The search's end, beside the unknowns and the processes themselves.
struct SearchEnd {
  std::vector<int> held_at_zero;  // dampings on their bound
  SetupFit setup;
  bool processes_settled = false;  // the last search for them
  bool likelihood_settled = false;
};

// What is known of every segment's globals beforehand, about where they are now; those in
// `held_at_zero` are held.
std::vector<GlobalsPrior> PriorsOf(const JointOptions& options,
                                   const JointUnknowns& unknowns,
                                   const std::vector<int>& held_at_zero);

// Processes and mode in turns until the likelihood settles, then the setup, and where that moves
// all of it again; docs/joint_refinement.md, "How it is solved". False, with the reason in the
// summary, if the search failed.
bool SearchJoint(const JointOptions& options,
                 JointStart* at,
                 SearchEnd* end,
                 JointSummary* summary);

}  // namespace fathom
