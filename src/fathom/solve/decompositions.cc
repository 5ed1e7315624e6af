// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/solve/decompositions.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>

namespace fathom {

SymmetricEigen EigenOf(const Eigen::MatrixXd& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(symmetric);
  return {eigen.eigenvalues(), eigen.eigenvectors()};
}

double LeastEigenvalue(const Eigen::MatrixXd& symmetric) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly)
      .eigenvalues()[0];
}

ColumnSpace ColumnSpaceOf(const Eigen::MatrixXd& matrix, double threshold) {
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(matrix);
  qr.setThreshold(threshold);
  const Eigen::Index rank = qr.rank();
  return {qr.householderQ() * Eigen::MatrixXd::Identity(matrix.rows(), rank),
          qr.matrixR().diagonal().head(rank)};
}

Eigen::Index RankOf(const Eigen::MatrixXd& matrix, double threshold) {
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(matrix);
  qr.setThreshold(threshold);
  return qr.rank();
}

PivotedQr::PivotedQr(const Eigen::MatrixXd& matrix) : qr_(matrix) {}

Eigen::Index PivotedQr::Rank() const { return qr_.rank(); }

Eigen::MatrixXd PivotedQr::QTimes(const Eigen::MatrixXd& columns) const {
  return qr_.householderQ() * columns;
}

Eigen::MatrixXd PivotedQr::TransposedQTimes(const Eigen::MatrixXd& columns) const {
  return qr_.householderQ().adjoint() * columns;
}

Eigen::VectorXd PivotedQr::Solve(const Eigen::VectorXd& right) const { return qr_.solve(right); }

Eigen::VectorXd SolveSymmetric(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
  return matrix.ldlt().solve(right);
}

Eigen::MatrixXd SolveSymmetricColumns(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right) {
  return matrix.ldlt().solve(right);
}

Eigen::MatrixXd InverseOfSymmetric(const Eigen::MatrixXd& matrix) {
  return SolveSymmetricColumns(matrix, Eigen::MatrixXd::Identity(matrix.rows(), matrix.cols()));
}

Eigen::MatrixXd LeastSquares(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right) {
  return matrix.completeOrthogonalDecomposition().solve(right);
}

Eigen::MatrixXd PseudoInverse(const Eigen::MatrixXd& matrix, double threshold) {
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
  if (threshold > 0.0) decomposition.setThreshold(threshold);
  decomposition.compute(matrix);
  return decomposition.pseudoInverse();
}

}  // namespace fathom
