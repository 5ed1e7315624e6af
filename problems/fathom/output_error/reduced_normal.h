// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/parameters.h"

#include <limits>

#include <Eigen/Core>

namespace fathom {

// Columns of a segment's signatures: the parameters, then a time offset of the command.
inline constexpr int kSharedColumns = kNumParameters + 1;

// Normal matrix A and score variance B of what several segments share, after their initial states
// are eliminated; docs/output_error.md (7). Columns: the inertia, both dampings, the offsets
// (buoyancies), the time offset.
struct ReducedNormal {
  explicit ReducedNormal(Eigen::Index num_offsets);
  Eigen::Index num_offsets() const { return A.cols() - kNumParameters; }

  Eigen::MatrixXd A, B;
  Eigen::VectorXd norm_squared;  // of full signatures
};

// Adds a segment, in which this offset acts, given its matrices A and B before elimination: its
// kSharedColumns, then its initial state.
void AddSegment(const Eigen::MatrixXd& A,
                const Eigen::MatrixXd& B,
                Eigen::Index offset,
                ReducedNormal* normal);

// A^-1 B A^-1, and each column's surviving share; NaN, the shares 0, where the columns are linearly
// dependent. The buoyancy is the mean of the offsets.
struct SolvedNormal {
  ParameterCovariance covariance;
  ParameterVector share = ParameterVector::Zero();
  Eigen::VectorXd offset_variance;
  double condition_number = std::numeric_limits<double>::quiet_NaN();

  // How the parameters follow a time offset of the command that is not fitted [per second].
  ParameterVector change_per_second_of_offset;
};

// With or without the time offset among what is fitted. Computed on columns of unit length, since
// the parameters' units differ by orders of magnitude.
SolvedNormal Solve(const ReducedNormal& normal, bool with_time_offset);

}  // namespace fathom
