// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/parameters.h"

#include <limits>

#include <Eigen/Core>

namespace fathom {

// Columns of the signatures that all segments share: the parameters, then a time offset.
inline constexpr int kSharedColumns = kNumParameters + 1;

// Normal matrix A and score variance B of the shared columns, after the segments' initial states
// are eliminated; docs/output_error.md (7).
struct ReducedNormal {
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(kSharedColumns, kSharedColumns);
  Eigen::MatrixXd B = Eigen::MatrixXd::Zero(kSharedColumns, kSharedColumns);
  Eigen::VectorXd norm_squared = Eigen::VectorXd::Zero(kSharedColumns);  // of full signatures
};

// Adds a segment, given its matrices A and B before elimination: the shared columns, then its
// initial state.
void AddSegment(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B, ReducedNormal* normal);

// A^-1 B A^-1 of the leading columns, and each one's surviving share; NaN, the shares 0, where they
// are linearly dependent.
struct SolvedNormal {
  Eigen::MatrixXd covariance;
  Eigen::VectorXd share;
  double condition_number = std::numeric_limits<double>::quiet_NaN();
};

// Of the first `size` columns; computed on columns of unit length, since the parameters' units
// differ by orders of magnitude.
SolvedNormal Solve(const ReducedNormal& normal, int size);

}  // namespace fathom
