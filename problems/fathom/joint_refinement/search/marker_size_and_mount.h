// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/joint_refinement/problem/joint_state.h"
#include "fathom/joint_refinement/problem/linear_joint.h"
#include "fathom/joint_refinement/processes/process_set.h"
#include "fathom/joint_refinement/search/setup_likelihood.h"

#include <string>

#include <Eigen/Core>

namespace fathom {

struct SetupFit {
  bool converged = false;
  bool moved = false;   // from where it was
  std::string message;  // if it did not converge

  // Of the size scale and the mount, the rows and columns of what is held 0: what all corners and
  // the priors tell, everything else unknown. Minus the curvature of the likelihood.
  SetupInformation information = SetupInformation::Zero();
};

// The size scale and the mount of greatest restricted likelihood: docs/joint_refinement.md (14),
// (15). Not the mode over deviations and setup: a smaller world needs smaller deviations, and their
// densities are then higher, for no reason that the corners know of.
//
// `unknowns` are at the mode under their present setup, and are so again under the new one;
// `processes` go with the size. Nothing is done where `priors_at` hold the setup. `earlier`: what
// an earlier search of the same problem found, or nothing.
SetupFit FitMarkerSizeAndMount(const PriorsAt& priors_at,
                               const SetupFit& earlier,
                               JointData* data,
                               ProcessSet* processes,
                               JointUnknowns* unknowns);

}  // namespace fathom
