// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <Eigen/QR>

// Decompositions of dense matrices, by Eigen and compiled once: its templates take seconds in each
// file that uses one.

namespace fathom {

// A symmetric matrix is vectors diag(values) vectors'; the values rise.
struct SymmetricEigen {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};
SymmetricEigen EigenOf(const Eigen::MatrixXd& symmetric);

double LeastEigenvalue(const Eigen::MatrixXd& symmetric);

// What the columns of a matrix span, by pivoted Householder reflections. A pivot below `threshold`
// of the greatest is none.
struct ColumnSpace {
  Eigen::MatrixXd basis;   // orthonormal, as many columns as the rank
  Eigen::VectorXd pivots;  // as many, of either sign
};
ColumnSpace ColumnSpaceOf(const Eigen::MatrixXd& matrix, double threshold);

Eigen::Index RankOf(const Eigen::MatrixXd& matrix, double threshold);

// Q R of a matrix whose columns are pivoted; the first `rank` columns of the square Q span it.
class PivotedQr {
 public:
  PivotedQr() = default;
  explicit PivotedQr(const Eigen::MatrixXd& matrix);

  Eigen::Index Rank() const;
  Eigen::MatrixXd QTimes(const Eigen::MatrixXd& columns) const;
  Eigen::MatrixXd TransposedQTimes(const Eigen::MatrixXd& columns) const;
  // The x with the least |matrix x - right| that has as many entries besides 0 as the rank.
  Eigen::VectorXd Solve(const Eigen::VectorXd& right) const;

 private:
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr_;
};

// The x with matrix x = right, of a symmetric matrix that has no eigenvalue below 0.
Eigen::VectorXd SolveSymmetric(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);
// The same column by column.
Eigen::MatrixXd SolveSymmetricColumns(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);
Eigen::MatrixXd InverseOfSymmetric(const Eigen::MatrixXd& matrix);

// The shortest x with the least |matrix x - right|, column by column.
Eigen::MatrixXd LeastSquares(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);

// Directions below `threshold` of the greatest pivot are none; 0: below rounding.
Eigen::MatrixXd PseudoInverse(const Eigen::MatrixXd& matrix, double threshold = 0.0);

}  // namespace fathom
