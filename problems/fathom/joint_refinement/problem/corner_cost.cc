// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/problem/corner_cost.h"

#include <algorithm>

#include <ceres/cost_function.h>

namespace fathom {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

class CornerCost final : public ceres::CostFunction {
 public:
  explicit CornerCost(const CornerCostOf& of)
      : of_(of), marker_(*of.data.segments[of.segment].map.Find(of.detection.tag_id)) {
    set_num_residuals(8);
    auto* const sizes = mutable_parameter_block_sizes();
    if (!of.moving.empty()) sizes->push_back(static_cast<int>(of.moving.size()));
    sizes->insert(sizes->end(), {kModelColumns, 2, kNumResponse});
    first_columns_ = {0, kStartColumns, kResponseColumns};
    if (of.with_clock) {
      sizes->push_back(1);
      first_columns_.push_back(kClockColumn);
    }
  }

  bool Evaluate(const double* const* parameters,
                double* residuals,
                double** jacobians) const override {
    if (!of_.motions.is_valid(of_.segment)) return false;
    const PredictedMotion& motion = of_.data.segments[of_.segment].motion;
    PoseVector eta = motion.Mean(of_.frame);
    for (size_t i = 0; i < of_.moving.size(); ++i) eta[of_.moving[i]] += parameters[0][i];
    CornerRows rows;
    if (!EvaluateCorners(of_.data.setup,
                         of_.unknowns.setup,
                         marker_,
                         of_.detection,
                         eta,
                         of_.corner_sigma,
                         false,
                         &rows)) {
      return false;
    }
    std::copy_n(rows.residual.data(), 8, residuals);
    if (jacobians == nullptr) return true;
    FillJacobians(rows, jacobians);
    return true;
  }

 private:
  void FillJacobians(const CornerRows& rows, double** jacobians) const {
    size_t block = 0;
    if (!of_.moving.empty()) {
      if (double* const out = jacobians[block++]; out != nullptr) {
        Eigen::Map<RowMajor>(out, 8, static_cast<Eigen::Index>(of_.moving.size())) =
            rows.by_pose(Eigen::all, of_.moving);
      }
    }
    const bool is_model_held = std::all_of(
        jacobians + block, jacobians + parameter_block_sizes().size(), [](const double* jacobian) {
          return jacobian == nullptr;
        });
    if (is_model_held) return;
    const PredictedMotion::Derivatives mean =
        of_.data.segments[of_.segment].motion.MeanDerivatives(of_.frame);
    for (const int first : first_columns_) {
      const int size = parameter_block_sizes()[block];
      if (double* const out = jacobians[block++]; out != nullptr) {
        Eigen::Map<RowMajor> J(out, 8, size);
        J.noalias() = rows.by_pose * mean.middleCols(first, size);
      }
    }
  }

  const CornerCostOf of_;
  const Marker& marker_;
  std::vector<int> first_columns_;
};

}  // namespace

std::unique_ptr<ceres::CostFunction> MakeCornerCost(const CornerCostOf& of) {
  return std::make_unique<CornerCost>(of);
}

}  // namespace fathom
