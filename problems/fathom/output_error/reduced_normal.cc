// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/reduced_normal.h"

#include "fathom/solve/decompositions.h"

#include <cmath>
#include <vector>

#include <Eigen/Dense>

namespace fathom {
namespace {

constexpr double kNotComputed = std::numeric_limits<double>::quiet_NaN();

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

// Takes the columns of a ReducedNormal, without the time offset, to the parameters.
Matrix ToParameters(Eigen::Index num_offsets) {
  Matrix to = Matrix::Zero(kNumParameters, kBuoyancy + num_offsets);
  to.topLeftCorner(kBuoyancy, kBuoyancy).setIdentity();
  to.row(kBuoyancy).tail(num_offsets).setConstant(1.0 / static_cast<double>(num_offsets));
  return to;
}

}  // namespace

ReducedNormal::ReducedNormal(Eigen::Index num_offsets) {
  const Eigen::Index size = kNumParameters + num_offsets;
  A = B = Matrix::Zero(size, size);
  norm_squared = Vector::Zero(size);
}

void AddSegment(const Matrix& A, const Matrix& B, Eigen::Index offset, ReducedNormal* normal) {
  const Eigen::Index num_states = A.cols() - kSharedColumns;
  const Matrix A_ps = A.topRightCorner(kSharedColumns, num_states);
  // Where (nearly) all samples are clipped, an initial state leaves no trace in A, and nothing of
  // the parameters' can be laid at its door: the pseudoinverse.
  const Matrix A_ss = PseudoInverse(A.bottomRightCorner(num_states, num_states), 1e-13);
  Matrix eliminate(kSharedColumns, A.cols());
  eliminate << Matrix::Identity(kSharedColumns, kSharedColumns), -A_ps * A_ss;
  std::vector<Eigen::Index> at = {kInertia, kQuadraticDamping, kLinearDamping};
  at.push_back(kBuoyancy + offset);
  at.push_back(normal->A.cols() - 1);
  normal->A(at, at) += eliminate * A.leftCols(kSharedColumns);
  normal->B(at, at) += eliminate * B * eliminate.transpose();
  normal->norm_squared(at) += A.diagonal().head(kSharedColumns);
}

SolvedNormal Solve(const ReducedNormal& normal, bool with_time_offset) {
  const Eigen::Index num_own = kBuoyancy + normal.num_offsets();
  const Eigen::Index size = num_own + (with_time_offset ? 1 : 0);
  const Vector unscale = normal.norm_squared.head(size).cwiseSqrt().cwiseInverse();
  const auto scaled = [&](const Matrix& whole) -> Matrix {
    return unscale.asDiagonal() * whole.topLeftCorner(size, size) * unscale.asDiagonal();
  };
  const Matrix A = scaled(normal.A), B = scaled(normal.B);
  SolvedNormal solved;
  solved.covariance.setConstant(kNotComputed);
  solved.offset_variance = Vector::Constant(normal.num_offsets(), kNotComputed);
  const Matrix to = ToParameters(normal.num_offsets());
  // The residuals that an offset leaves, fitted by the parameters alone.
  solved.change_per_second_of_offset =
      -to *
      normal.A.topLeftCorner(num_own, num_own).ldlt().solve(normal.A.topRightCorner(num_own, 1));
  const Vector eigenvalues = EigenOf(A).values;
  const double smallest = eigenvalues.minCoeff(), largest = eigenvalues.maxCoeff();
  if (!(smallest > 1e-13 * largest)) return solved;
  solved.condition_number = std::sqrt(largest / smallest);
  const Matrix A_inverse = A.inverse();
  const Matrix covariance =
      unscale.asDiagonal() * (A_inverse * B * A_inverse) * unscale.asDiagonal();
  const Matrix spread = unscale.asDiagonal() * A_inverse * unscale.asDiagonal();
  solved.covariance = to * covariance.topLeftCorner(num_own, num_own) * to.transpose();
  solved.offset_variance = covariance.diagonal().segment(kBuoyancy, normal.num_offsets());
  // What is left of a signature, over the whole of it. The mean offset moves all of them together.
  ParameterVector norm_squared = normal.norm_squared.head<kNumParameters>();
  norm_squared[kBuoyancy] = normal.norm_squared.segment(kBuoyancy, normal.num_offsets()).sum();
  solved.share = (to * spread.topLeftCorner(num_own, num_own) * to.transpose())
                     .diagonal()
                     .cwiseProduct(norm_squared)
                     .cwiseInverse()
                     .cwiseSqrt();
  return solved;
}

}  // namespace fathom
