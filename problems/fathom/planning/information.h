// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/planning/planned_motion.h"
#include "fathom/planning/stamp_noise.h"

#include <Eigen/Core>

namespace fathom {

// The Fisher information that a run gives about the parameters, docs/plan.md (1): what the start
// could imitate counts for nothing. `noise`: standard deviation of one velocity of the run.
Eigen::MatrixXd InformationOf(const MotionDerivatives& derivatives, double noise);

// The inverse of the covariance that plain squares have under coloured noise, docs/plan.md (8):
// fits do not know the colour. Under white noise the same as above. Directions that leave no trace
// have none.
Eigen::MatrixXd InformationOf(const MotionDerivatives& derivatives, const StampNoise& noise);

// ln det of a positive definite matrix; minus infinity of any other.
double LogDetOf(const Eigen::MatrixXd& matrix);

// What the search for a command makes as great as it can, docs/plan.md (2): the ln det of the
// information in sizes of the parameters, less the ln of the weakest one's variance. Minus infinity
// of a matrix that is not positive definite.
double WorthOfInformation(const Eigen::MatrixXd& information, const Eigen::VectorXd& sizes);

// The inverse of a positive definite matrix, scaled for it to unit diagonal. Infinite on the
// diagonal of any other: nothing is known.
Eigen::MatrixXd InverseOf(const Eigen::MatrixXd& matrix);

}  // namespace fathom
