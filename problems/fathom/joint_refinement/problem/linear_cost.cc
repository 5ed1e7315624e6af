// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/problem/linear_cost.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Core>
#include <ceres/cost_function.h>

namespace fathom {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// W (sum over blocks of M_b x_b - offset): everything that is linear.
class LinearCost final : public ceres::CostFunction {
 public:
  explicit LinearCost(std::vector<RowMajor> blocks, Eigen::VectorXd offset)
      : blocks_(std::move(blocks)), offset_(std::move(offset)) {
    set_num_residuals(static_cast<int>(offset_.size()));
    for (const RowMajor& block : blocks_) {
      mutable_parameter_block_sizes()->push_back(static_cast<int>(block.cols()));
    }
  }

  bool Evaluate(const double* const* parameters,
                double* residuals,
                double** jacobians) const override {
    Eigen::Map<Eigen::VectorXd> r(residuals, offset_.size());
    r = -offset_;
    for (size_t b = 0; b < blocks_.size(); ++b) {
      r.noalias() +=
          blocks_[b] * Eigen::Map<const Eigen::VectorXd>(parameters[b], blocks_[b].cols());
      if (jacobians != nullptr && jacobians[b] != nullptr) {
        std::copy_n(blocks_[b].data(), blocks_[b].size(), jacobians[b]);
      }
    }
    return true;
  }

 private:
  const std::vector<RowMajor> blocks_;
  const Eigen::VectorXd offset_;
};

}  // namespace

std::unique_ptr<ceres::CostFunction> MakeStepCost(const ProcessSet& processes,
                                                  int excited,
                                                  const std::vector<int>& moving,
                                                  double duration) {
  const auto n = static_cast<Eigen::Index>(moving.size());
  std::vector<RowMajor> blocks(4, RowMajor::Zero(2 * n, n));
  for (Eigen::Index i = 0; i < n; ++i) {
    const int c = moving[i];
    const SecondOrderProcess process = processes.Of(c, excited);
    const Transition t = process.Over(duration);
    const Eigen::Matrix2d from = -t.whitener * t.Phi;
    for (int row = 0; row < 2; ++row) {
      for (int s = 0; s < 2; ++s) {
        blocks[s](2 * i + row, i) = from(row, s);
        blocks[2 + s](2 * i + row, i) = t.whitener(row, s);
      }
    }
  }
  return std::make_unique<LinearCost>(std::move(blocks), Eigen::VectorXd::Zero(2 * n));
}

std::unique_ptr<ceres::CostFunction> MakeFirstCost(const ProcessSet& processes,
                                                   int excited,
                                                   const std::vector<int>& moving) {
  const auto n = static_cast<Eigen::Index>(moving.size());
  std::vector<RowMajor> blocks(2, RowMajor::Zero(2 * n, n));
  for (Eigen::Index i = 0; i < n; ++i) {
    const int c = moving[i];
    Eigen::Vector2d std(kStartStd, kStartStd);
    if (c != excited) {
      std = processes.Of(c, excited).StationaryCovariance().diagonal().cwiseSqrt();
    }
    for (int s = 0; s < 2; ++s) blocks[s](2 * i + s, i) = 1.0 / std[s];
  }
  return std::make_unique<LinearCost>(std::move(blocks), Eigen::VectorXd::Zero(2 * n));
}

std::unique_ptr<ceres::CostFunction> MakePriorCost(const std::vector<double>& std,
                                                   const std::vector<double>& mean) {
  std::vector<int> rows;
  for (size_t i = 0; i < std.size(); ++i) {
    if (std[i] > 0.0 && std::isfinite(std[i])) rows.push_back(static_cast<int>(i));
  }
  if (rows.empty()) return nullptr;
  RowMajor M =
      RowMajor::Zero(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(std.size()));
  Eigen::VectorXd offset(M.rows());
  for (Eigen::Index i = 0; i < M.rows(); ++i) {
    M(i, rows[i]) = 1.0 / std[rows[i]];
    offset[i] = mean[rows[i]] / std[rows[i]];
  }
  return std::make_unique<LinearCost>(std::vector<RowMajor>{M}, offset);
}

}  // namespace fathom
