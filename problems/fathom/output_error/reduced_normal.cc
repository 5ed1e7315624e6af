// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/reduced_normal.h"

#include <cmath>

#include <Eigen/Dense>

namespace fathom {
namespace {

constexpr double kNotComputed = std::numeric_limits<double>::quiet_NaN();

using Matrix = Eigen::MatrixXd;

}  // namespace

void AddSegment(const Matrix& A, const Matrix& B, ReducedNormal* normal) {
  const Eigen::Index num_states = A.cols() - kSharedColumns;
  const Matrix A_ps = A.topRightCorner(kSharedColumns, num_states);
  // Where (nearly) all samples are clipped, an initial state leaves no trace in A, and nothing of
  // the parameters' can be laid at its door: the pseudoinverse.
  Eigen::CompleteOrthogonalDecomposition<Matrix> A_ss;
  A_ss.setThreshold(1e-13);
  A_ss.compute(A.bottomRightCorner(num_states, num_states));
  Matrix eliminate(kSharedColumns, A.cols());
  eliminate << Matrix::Identity(kSharedColumns, kSharedColumns), -A_ps * A_ss.pseudoInverse();
  normal->A += eliminate * A.leftCols(kSharedColumns);
  normal->B += eliminate * B * eliminate.transpose();
  normal->norm_squared += A.diagonal().head(kSharedColumns);
}

SolvedNormal Solve(const ReducedNormal& normal, int size) {
  const Eigen::VectorXd scale = normal.norm_squared.head(size).cwiseSqrt();
  const Eigen::VectorXd unscale = scale.cwiseInverse();
  const Matrix A = unscale.asDiagonal() * normal.A.topLeftCorner(size, size) * unscale.asDiagonal();
  const Matrix B = unscale.asDiagonal() * normal.B.topLeftCorner(size, size) * unscale.asDiagonal();
  SolvedNormal solved;
  const Eigen::SelfAdjointEigenSolver<Matrix> eigen(A);
  const double smallest = eigen.eigenvalues().minCoeff();
  solved.covariance = Matrix::Constant(size, size, kNotComputed);
  solved.share = Eigen::VectorXd::Constant(size, 0.0);
  if (!(smallest > 1e-13 * eigen.eigenvalues().maxCoeff())) return solved;
  solved.condition_number = std::sqrt(eigen.eigenvalues().maxCoeff() / smallest);
  const Matrix A_inverse = A.inverse();
  solved.covariance = unscale.asDiagonal() * (A_inverse * B * A_inverse) * unscale.asDiagonal();
  solved.share = A_inverse.diagonal().cwiseInverse().cwiseSqrt();
  return solved;
}

}  // namespace fathom
