// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled/coupled_fit.h"
#include "fathom/coupled/folds.h"
#include "fathom/simulate/coupled/coupled_data.h"
#include "fathom/vehicle/coupled/motion_structure.h"
#include "fathom/vehicle/coupled/six_vector.h"

#include <array>
#include <span>
#include <vector>

namespace fathom {

// Absolute errors of free runs of 5 s over data that were not fitted; rows by Index(Dof) [m/s],
// [rad/s].
struct UnseenErrors {
  bool is_known = false;                                      // false: a fit or a run failed
  std::vector<Vector6> by_window;                             // means over the runs
  Vector6 error = Vector6::Zero(), motion = Vector6::Zero();  // sums over samples
};

// Of a structure, fitted anew to the training part of each fold from `fit`, with its noise.
UnseenErrors UnseenErrorsOf(const std::vector<Fold>& folds,
                            const MotionStructure& structure,
                            const CoupledSummary& fit,
                            const CoupledFitOptions& options);

// Of models that something else fitted to the training part of each fold, in the order of the
// folds.
UnseenErrors UnseenErrorsOf(const std::vector<Fold>& folds,
                            const std::vector<CoupledModel>& models);

// NMAE, docs/models.md (8), by Index(Dof); NaN where not known.
std::array<double, 6> NmaeOf(const UnseenErrors& errors, const std::vector<Dof>& dofs);

// By how much the runs of `b` are nearer than those of `a`, over the same folds: the mean over DOFs
// of the share by which errors shrink, and that in standard errors. Both are known.
struct UnseenGain {
  double share = 0.0;
  double in_errors = 0.0;
};
UnseenGain GainOf(const UnseenErrors& a, const UnseenErrors& b, const std::vector<Dof>& dofs);

}  // namespace fathom
