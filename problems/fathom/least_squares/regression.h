// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/signal/signals.h"
#include "fathom/vehicle/parameters.h"

#include <span>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// The linear problem of docs/least_squares.md (1): acceleration = F (alpha, beta, mu, nu).
struct Regression {
  Eigen::MatrixX4d F;            // rows (tau, v|v|, v, 1)
  Eigen::VectorXd acceleration;  // [m/s^2] or [rad/s^2]

  // Rows piece_begin[k] to piece_begin[k + 1] - 1 are an unbroken run of samples; the last entry is
  // the number of rows.
  std::vector<Eigen::Index> piece_begin;
};

// The samples of `segments` whose acceleration, smoothed_velocity and smoothed_force are finite.
Regression RegressionOf(std::span<const Segment> segments);

// Covariance of the solution for residuals coloured like an autoregression of at most `max_order`;
// docs/least_squares.md (4). `inverse_gram` is (F'F)^-1.
Eigen::Matrix4d CovarianceOf(const Regression& regression,
                             const Eigen::VectorXd& residual,
                             const Eigen::Matrix4d& inverse_gram,
                             int max_order);

// m = 1/alpha, d_Q = -beta/alpha, d_L = -mu/alpha, b = -nu/alpha; docs/least_squares.md (2).
ParameterVector ParametersOf(const Eigen::Vector4d& lumped);

// Jacobian of that map at `lumped`.
Eigen::Matrix4d ParameterJacobian(const Eigen::Vector4d& lumped);

}  // namespace fathom
