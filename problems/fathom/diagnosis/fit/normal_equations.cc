// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/fit/normal_equations.h"

#include "fathom/solve/decompositions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numeric>

#include <Eigen/Core>

namespace fathom {
namespace {

// The scaled pseudo-inverse of the normal matrix of some unknowns, and for each the share of it
// that the data tell: 1, or less where a combination with others leaves no trace.
struct Inverse {
  Eigen::MatrixXd covariance;
  Eigen::VectorXd told;
};

Inverse InverseOf(const Normal& normal, const std::vector<int>& some) {
  const auto n = static_cast<Eigen::Index>(some.size());
  Eigen::MatrixXd A(n, n);
  Eigen::VectorXd scale(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    scale[i] = 1.0 / std::sqrt(std::max(normal.A(some[i], some[i]), 1e-300));
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      A(i, j) = scale[i] * scale[j] * normal.A(some[i], some[j]);
    }
  }
  const Eigen::MatrixXd inverse = PseudoInverse(A);
  return {(scale * scale.transpose()).cwiseProduct(inverse), (inverse * A).diagonal()};
}

}  // namespace

// Segment by segment: most columns are free states, each of which has rows in one alone.
Normal NormalOf(const Whitener& whitener,
                const RowMajorMatrix& jacobian,
                const Eigen::VectorXd& residual) {
  Normal normal = {Eigen::MatrixXd::Zero(jacobian.cols(), jacobian.cols()),
                   Eigen::VectorXd::Zero(jacobian.cols())};
  const std::vector<int>& first_rows = whitener.first_rows();
  for (std::size_t segment = 0; segment + 1 < first_rows.size(); ++segment) {
    const int begin = first_rows[segment], count = first_rows[segment + 1] - begin;
    const auto rows = jacobian.middleRows(begin, count);
    std::vector<Eigen::Index> columns;
    const Eigen::RowVectorXd largest = rows.cwiseAbs().colwise().maxCoeff();
    for (Eigen::Index k = 0; k < rows.cols(); ++k) {
      if (largest[k] > 0.0) columns.push_back(k);
    }
    const Eigen::Index n = std::ssize(columns);
    RowMajorMatrix whitened(count, n + 1);
    whitened.leftCols(n) = rows(Eigen::all, columns);
    whitened.col(n) = residual.segment(begin, count);
    whitener.ApplyToSegment(segment, whitened, whitened);
    Eigen::MatrixXd product = Eigen::MatrixXd::Zero(n + 1, n + 1);
    product.selfadjointView<Eigen::Lower>().rankUpdate(whitened.transpose());
    for (Eigen::Index j = 0; j < n; ++j) {
      for (Eigen::Index i = j; i < n; ++i) normal.A(columns[i], columns[j]) += product(i, j);
      normal.g[columns[j]] += product(n, j);
    }
  }
  normal.A.triangularView<Eigen::StrictlyUpper>() = normal.A.transpose();
  return normal;
}

Eigen::VectorXd StepOf(const Normal& normal, const std::vector<int>& free, double damping) {
  const auto n = static_cast<Eigen::Index>(free.size());
  Eigen::MatrixXd A(n, n);
  Eigen::VectorXd g(n), scale(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    scale[i] = 1.0 / std::sqrt(std::max(normal.A(free[i], free[i]), 1e-300));
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    g[i] = scale[i] * normal.g[free[i]];
    for (Eigen::Index j = 0; j < n; ++j) {
      A(i, j) = scale[i] * scale[j] * normal.A(free[i], free[j]);
    }
    A(i, i) += damping + 1e-12;
  }
  const Eigen::VectorXd solved = SolveSymmetric(A, g);
  Eigen::VectorXd step = Eigen::VectorXd::Zero(normal.g.size());
  for (Eigen::Index i = 0; i < n; ++i) step[free[i]] = scale[i] * solved[i];
  return step;
}

Eigen::MatrixXd CovarianceOf(const Normal& normal,
                             const std::vector<int>& free,
                             int num_parameters) {
  const auto n = static_cast<Eigen::Index>(free.size());
  const Eigen::MatrixXd of_free = InverseOf(normal, free).covariance;
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(num_parameters, num_parameters);
  for (Eigen::Index i = 0; i < n && free[i] < num_parameters; ++i) {
    for (Eigen::Index j = 0; j < n && free[j] < num_parameters; ++j) {
      covariance(free[i], free[j]) = of_free(i, j);
    }
  }
  if (n == normal.g.size()) return covariance;
  constexpr double kTold = 0.999;
  std::vector<int> all(normal.g.size());
  std::iota(all.begin(), all.end(), 0);
  const Inverse of_all = InverseOf(normal, all);
  for (int i = 0; i < num_parameters; ++i) {
    if (std::count(free.begin(), free.end(), i) > 0) continue;
    covariance(i, i) =
        of_all.told[i] > kTold ? of_all.covariance(i, i) : std::numeric_limits<double>::quiet_NaN();
  }
  return covariance;
}

}  // namespace fathom
