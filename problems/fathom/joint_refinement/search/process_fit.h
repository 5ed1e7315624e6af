// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/joint_refinement/problem/linear_joint.h"
#include "fathom/joint_refinement/processes/process_set.h"

#include <limits>
#include <span>

namespace fathom {

struct ProcessFit {
  bool converged = false;
  ProcessSet processes;
  double log_likelihood = -std::numeric_limits<double>::infinity();
  int num_evaluations = 0;
};

// The processes of greatest restricted likelihood, found from `start` by its slope. Which responses
// and which wanders there are is decided here: a component that raises the log-likelihood by less
// than three is left out. docs/joint_refinement.md (11), (12)
ProcessFit FitProcesses(std::span<const LinearSegment> segments,
                        std::span<const GlobalsPrior> priors,
                        const ProcessSet& start,
                        int excited);

}  // namespace fathom
