// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/ordinary_dives/run_noise.h"
#include "fathom/planning/planned_motion.h"

#include <span>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// What runs add to the normal equations of one fit to all of them by plain squares:
//
//   A = sum X' X,   B = sigma^2 sum X' Gamma X,   M = A B^-1 A             docs/plan.md (10)
//
//   X       derivatives of a run's output by the parameters, less what its start imitates
//   Gamma   correlations of the noise, whose standard deviation is sigma
//   M       inverse of the covariance of the parameters
struct RunNormal {
  Eigen::MatrixXd A, B;

  // Of runs that tell nothing.
  static RunNormal Zero(Eigen::Index num_parameters);

  void Add(const RunNormal& other, double times = 1.0);

  // M. Directions that leave no trace have none.
  Eigen::MatrixXd Information() const;
};

// Of one run at these stamps, by the output of the fit. `places`: of the parameters that are asked
// for, among the columns of the derivatives.
RunNormal NormalOfRun(const MotionDerivatives& derivatives,
                      std::span<const double> stamps,
                      const std::vector<Eigen::Index>& places,
                      const RunNoise& noise);

}  // namespace fathom
