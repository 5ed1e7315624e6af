// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/noise/noise_model.h"

#include <span>

#include <Eigen/Core>

namespace fathom {

// The covariance of velocity samples under white and coloured sensor noise, entry by entry:
// docs/residual_noise.md (1), (2). What the Kalman filter whitens without it.
Eigen::MatrixXd DenseCovariance(const NoiseModel& noise, std::span<const NoiseSample> samples);

// Generalised least squares of y on the columns of X, by the normal equations with S inverted.
struct DenseFit {
  Eigen::VectorXd solution;
  Eigen::MatrixXd information;  // X' S^-1 X
  double chi_squared = 0.0;     // of what is left
};

DenseFit FitDense(const Eigen::MatrixXd& S, const Eigen::MatrixXd& X, const Eigen::VectorXd& y);

}  // namespace fathom
