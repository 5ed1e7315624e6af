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
// after ten orders in a row that bring nothing. Hand the pieces over with std::move to save a copy.
Autoregression FitAutoregression(std::vector<std::vector<double>> pieces, int max_order);

// The recursion of these covariances of samples 0, 1, 2 ... apart, at least one, the first above 0;
// its order is one below their number. By Levinson's method.
Autoregression AutoregressionOf(std::span<const double> covariances);

// The variance of sum_i J_i e_i over the samples i of one piece: J' Gamma J, where Gamma is the
// covariance matrix of the noise, docs/output_error.md (6). Rows of J belong to consecutive samples
// and arrive in the order of time, some at once; they are not kept.
class ColouredGram {
 public:
  ColouredGram(Autoregression noise, Eigen::Index num_columns);

  // The next rows.
  void Add(const Eigen::Ref<const Eigen::MatrixXd>& rows);

  // The sum over all rows so far; the piece is over, and the next row begins another one, with
  // noise of its own.
  Eigen::MatrixXd EndPiece();

 private:
  void AddBlock(const Eigen::Ref<const Eigen::MatrixXd>& rows);
  void FollowEcho();  // adds what the last filtered rows still cause after a piece

  const Autoregression noise_;
  Eigen::MatrixXd gram_;      // of the filtered rows so far
  Eigen::MatrixXd filtered_;  // the last order() filtered rows, then the block's
  Eigen::MatrixXd echo_;      // EchoOf() the noise, once it is needed
};

}  // namespace fathom
