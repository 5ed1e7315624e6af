// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/free_decay/decay_options.h"
#include "fathom/free_decay/decay_stretch.h"

#include <span>

#include <Eigen/Core>

namespace fathom {

// Where a search can start, in the order of DecayUnknowns: by least squares of (1), integrated.
// docs/free_decay.md (5).
Eigen::VectorXd DecayGuess(std::span<const DecayStretch> stretches,
                           const FreeDecayOptions& options);

}  // namespace fathom
