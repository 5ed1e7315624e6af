// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/block_regression.h"

#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/LU>

namespace fathom {
namespace {

constexpr int kBlocks = 16;
constexpr double kStudentOf15 = 2.131;  // 97.5 %, 15 degrees of freedom

Eigen::VectorXd Solution(const Eigen::MatrixXd& zx, const Eigen::VectorXd& zy) {
  const Eigen::FullPivLU<Eigen::MatrixXd> lu(zx);
  if (lu.isInvertible()) return lu.solve(zy);
  return Eigen::VectorXd::Constant(zy.size(), std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

BlockRegression RegressByBlocks(const Eigen::MatrixXd& regressors,
                                const Eigen::MatrixXd& instruments,
                                const Eigen::VectorXd& observed) {
  const Eigen::Index rows = observed.size(), size = regressors.cols();
  std::vector<Eigen::MatrixXd> zx;
  std::vector<Eigen::VectorXd> zy;
  Eigen::MatrixXd all_zx = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd all_zy = Eigen::VectorXd::Zero(size);
  for (int k = 0; k < kBlocks; ++k) {
    const Eigen::Index begin = rows * k / kBlocks, count = rows * (k + 1) / kBlocks - begin;
    const auto z = instruments.middleRows(begin, count).transpose();
    zx.push_back(z * regressors.middleRows(begin, count));
    zy.push_back(z * observed.segment(begin, count));
    all_zx += zx.back();
    all_zy += zy.back();
  }
  BlockRegression result;
  result.theta = Solution(all_zx, all_zy);
  result.squares = (observed - regressors * result.theta).squaredNorm();

  Eigen::MatrixXd without(size, kBlocks);
  for (int k = 0; k < kBlocks; ++k) without.col(k) = Solution(all_zx - zx[k], all_zy - zy[k]);
  const Eigen::MatrixXd scatter = without.colwise() - without.rowwise().mean();
  result.half_width = kStudentOf15 * std::sqrt((kBlocks - 1.0) / kBlocks) *
                      scatter.rowwise().squaredNorm().cwiseSqrt();
  return result;
}

}  // namespace fathom
