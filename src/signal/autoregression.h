// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// Coloured noise as a recursion over equally spaced samples:
//
//   e_i = phi_1 e_{i-1} + ... + phi_p e_{i-p} + innovation_i        docs/output_error.md (5)
//
// The innovations are white. Order 0 is white noise.
struct Autoregression {
  std::vector<double> coefficients;  // phi_1 ... phi_p, stable
  double innovation_variance = 0.0;  // squared unit of e

  int order() const { return static_cast<int>(coefficients.size()); }
};

// Fits by Burg's method over all `pieces` together; a piece is an unbroken run of samples, its mean
// taken as zero. The order, at most `max_order`, is the one with the least AIC; the search ends
// after ten orders in a row that bring nothing.
Autoregression FitAutoregression(std::span<const std::vector<double>> pieces, int max_order);

// J' Gamma J for the samples of one piece, where Gamma is the covariance matrix of the noise
// (docs/output_error.md (6)): the variance of sum_i J_i e_i. Rows of J belong to consecutive
// samples.
Eigen::MatrixXd ColouredGram(const Autoregression& noise, Eigen::MatrixXd J);

}  // namespace fathom
