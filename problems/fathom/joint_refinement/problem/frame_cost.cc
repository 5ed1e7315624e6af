// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/problem/frame_cost.h"

#include "fathom/joint_refinement/problem/clipped_loss.h"

#include <algorithm>
#include <cmath>

#include <Eigen/QR>
#include <ceres/cost_function.h>

namespace fathom {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr int kRows = 7;

class FrameCost final : public ceres::CostFunction {
 public:
  explicit FrameCost(const FrameCostOf& of) : of_(of) {
    for (const Detection& detection : Detections()) {
      markers_.push_back(of.data.segments[of.segment].map.Find(detection.tag_id));
    }
    set_num_residuals(kRows);
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
    return jacobians == nullptr ? EvaluateLoss(eta, residuals)
                                : EvaluateRows(eta, residuals, jacobians);
  }

 private:
  const std::vector<Detection>& Detections() const {
    return of_.data.segments[of_.segment].detections[of_.frame];
  }

  bool EvaluateLoss(const PoseVector& eta, double* residuals) const {
    double loss = 0.0;
    for (size_t d = 0; d < markers_.size(); ++d) {
      Eigen::Matrix<double, 8, 1> r;
      if (!EvaluateResidual(of_.data.setup,
                            of_.unknowns.setup,
                            *markers_[d],
                            Detections()[d],
                            eta,
                            of_.corner_sigma,
                            &r)) {
        return false;
      }
      loss += ClippedLoss::Of(r.squaredNorm(), of_.data.loss_limit).value;
    }
    std::fill_n(residuals, kRows - 1, 0.0);
    residuals[kRows - 1] = std::sqrt(loss);
    return true;
  }

  bool EvaluateRows(const PoseVector& eta, double* residuals, double** jacobians) const {
    // The rows of all corners, the residuals as a seventh column.
    Eigen::Matrix<double, Eigen::Dynamic, 7> all(8 * markers_.size(), 7);
    double loss = 0.0;
    for (size_t d = 0; d < markers_.size(); ++d) {
      CornerRows rows;
      if (!EvaluateCorners(of_.data.setup,
                           of_.unknowns.setup,
                           *markers_[d],
                           Detections()[d],
                           eta,
                           of_.corner_sigma,
                           false,
                           &rows)) {
        return false;
      }
      const auto of_detection = ClippedLoss::Of(rows.residual.squaredNorm(), of_.data.loss_limit);
      loss += of_detection.value;
      const double root = std::sqrt(of_detection.weight);
      all.middleRows<8>(8 * static_cast<Eigen::Index>(d)) << root * rows.by_pose,
          root * rows.residual;
    }
    const Eigen::HouseholderQR<Eigen::Ref<decltype(all)>> qr(all);
    const Eigen::Matrix<double, 6, 6> R = all.topLeftCorner<6, 6>().triangularView<Eigen::Upper>();
    Eigen::Map<Eigen::Matrix<double, kRows, 1>> r(residuals);
    r.head<6>() = all.topRightCorner<6, 1>();
    r[kRows - 1] = std::sqrt(std::max(0.0, loss - r.head<6>().squaredNorm()));
    FillJacobians(R, jacobians);
    return true;
  }

  void FillJacobians(const Eigen::Matrix<double, 6, 6>& R, double** jacobians) const {
    size_t block = 0;
    const auto fill = [&](auto&& columns) {
      double* const out = jacobians[block++];
      if (out == nullptr) return;
      Eigen::Map<RowMajor> J(out, kRows, columns.cols());
      J.topRows<6>() = columns;
      J.row(6).setZero();
    };
    if (!of_.moving.empty()) fill(R(Eigen::all, of_.moving));
    const bool is_model_held = std::all_of(
        jacobians + block, jacobians + parameter_block_sizes().size(), [](const double* jacobian) {
          return jacobian == nullptr;
        });
    if (is_model_held) return;
    const PredictedMotion::Derivatives mean =
        of_.data.segments[of_.segment].motion.MeanDerivatives(of_.frame);
    const PredictedMotion::Derivatives by_globals = R.lazyProduct(mean);
    for (const int first : first_columns_) {
      fill(by_globals.middleCols(first, parameter_block_sizes()[block]));
    }
  }

  const FrameCostOf of_;
  std::vector<const Marker*> markers_;  // of each detection
  std::vector<int> first_columns_;
};

}  // namespace

std::unique_ptr<ceres::CostFunction> MakeFrameCost(const FrameCostOf& of) {
  return std::make_unique<FrameCost>(of);
}

}  // namespace fathom
