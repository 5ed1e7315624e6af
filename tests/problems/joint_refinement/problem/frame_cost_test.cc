// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/problem/frame_cost.h"

#include "fathom/joint_refinement/problem/clipped_loss.h"

#include <array>
#include <cmath>
#include <vector>

#include "camera_experiment.h"
#include "truth.h"
#include <ceres/cost_function.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

constexpr double kCornerSigma = 0.3;  // [px]
constexpr size_t kFrame = 17;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// What Gauss and Newton take from the corners of a frame.
struct Equations {
  Eigen::MatrixXd JJ;
  Eigen::VectorXd Jr;
  double squares = 0.0;
};

// One marker of four is 20 px off: the loss does not take it in full.
class FrameCostTest : public testing::Test {
 protected:
  FrameCostTest()
      : truth_(TruthOf(Synthesize({.dof = Dof::kYaw, .num_markers = 4, .duration = 3.0}))) {
    for (auto& corner : Frame().front().corners) corner[0] += 20.0;
    SegmentUnknowns& own = truth_.unknowns.segments[0];
    PoseVector::Map(own.deviation[kFrame].data()) =
        PoseVector(0.01, -0.02, 0.03, 0.004, -0.005, 0.006);
    own.response.fill(0.02);
    motions_.PrepareForEvaluation(true, true);
    deviation_ = {own.deviation[kFrame][1], own.deviation[kFrame][4]};
    blocks_ = {deviation_.data(),
               truth_.unknowns.model.data(),
               own.start.data(),
               own.response.data(),
               &own.clock_offset};
  }

  std::vector<Detection>& Frame() { return truth_.data.segments[0].detections[kFrame]; }

  std::unique_ptr<ceres::CostFunction> Cost() {
    return MakeFrameCost(
        {truth_.data, motions_, moving_, truth_.unknowns, kCornerSigma, 0, kFrame, true});
  }

  // Of the frame's corners one by one.
  Equations OfCorners() {
    const PredictedMotion& motion = truth_.data.segments[0].motion;
    PoseVector eta = motion.Mean(kFrame);
    eta[1] += deviation_[0];
    eta[4] += deviation_[1];
    const PredictedMotion::Derivatives mean = motion.MeanDerivatives(kFrame);
    Eigen::MatrixXd by_unknowns(6, 2 + kModelColumns + 2 + kNumResponse + 1);
    by_unknowns << Eigen::Vector<double, 6>::Unit(1), Eigen::Vector<double, 6>::Unit(4),
        mean.leftCols<kModelColumns>(), mean.middleCols<2>(kStartColumns),
        mean.middleCols<kNumResponse>(kResponseColumns), mean.col(kClockColumn);
    Equations sum = {Eigen::MatrixXd::Zero(by_unknowns.cols(), by_unknowns.cols()),
                     Eigen::VectorXd::Zero(by_unknowns.cols())};
    for (const Detection& detection : Frame()) {
      CornerRows rows;
      EXPECT_TRUE(EvaluateCorners(truth_.data.setup,
                                  truth_.unknowns.setup,
                                  *truth_.data.segments[0].map.Find(detection.tag_id),
                                  detection,
                                  eta,
                                  kCornerSigma,
                                  false,
                                  &rows));
      const auto loss = ClippedLoss::Of(rows.residual.squaredNorm(), truth_.data.loss_limit);
      const Eigen::MatrixXd J = rows.by_pose * by_unknowns;
      sum.JJ += loss.weight * J.transpose() * J;
      sum.Jr += loss.weight * J.transpose() * rows.residual;
      sum.squares += loss.value;
    }
    return sum;
  }

  Truth truth_;
  MotionCallback motions_{&truth_.data, &truth_.unknowns, false};
  const std::vector<int> moving_ = {1, 4};
  std::array<double, 2> deviation_;
  std::vector<const double*> blocks_;
};

TEST_F(FrameCostTest, SaysWhatTheCornersSayOneByOne) {
  ASSERT_EQ(Frame().size(), 4u);
  const auto cost = Cost();
  std::vector<RowMajor> jacobians;
  for (const int size : cost->parameter_block_sizes()) jacobians.emplace_back(7, size);
  std::vector<double*> pointers;
  for (RowMajor& jacobian : jacobians) pointers.push_back(jacobian.data());
  Eigen::Matrix<double, 7, 1> r;
  ASSERT_TRUE(cost->Evaluate(blocks_.data(), r.data(), pointers.data()));
  const Equations corners = OfCorners();
  Eigen::MatrixXd J(7, corners.JJ.cols());
  J << jacobians[0], jacobians[1], jacobians[2], jacobians[3], jacobians[4];
  // Rounding, over what each column holds.
  const Eigen::VectorXd length = corners.JJ.diagonal().cwiseSqrt();
  for (Eigen::Index i = 0; i < J.cols(); ++i) {
    EXPECT_NEAR(J.col(i).dot(r), corners.Jr[i], 1e-11 * length[i] * r.norm()) << i;
    for (Eigen::Index j = 0; j < J.cols(); ++j) {
      EXPECT_NEAR(J.col(i).dot(J.col(j)), corners.JJ(i, j), 1e-11 * length[i] * length[j]);
    }
  }
  EXPECT_NEAR(r.squaredNorm(), corners.squares, 1e-12 * corners.squares);
}

TEST_F(FrameCostTest, HasTheSameSumOfSquaresWithoutDerivatives) {
  Eigen::Matrix<double, 7, 1> r;
  ASSERT_TRUE(Cost()->Evaluate(blocks_.data(), r.data(), nullptr));
  const double squares = OfCorners().squares;
  EXPECT_NEAR(r.squaredNorm(), squares, 1e-12 * squares);
}

}  // namespace
}  // namespace fathom
