// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/geometry/pose_increment.h"

#include <random>

#include <ceres/jet.h>
#include <ceres/rotation.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

const Pose kPose = {Eigen::Quaterniond(0.3, -0.5, 0.7, 0.2).normalized(), {1.0, -2.0, 0.5}};

PoseIncrement Step(double size) {
  PoseIncrement step;
  step << 0.3, -0.2, 0.5, 0.7, -0.4, 0.6;
  return size * step;
}

TEST(PoseIncrement, RotatesAsCeresDoes) {
  for (const double size : {1.0, 1e-3, 1e-7, 0.0}) {
    const Eigen::Vector3d phi = Step(size).tail<3>();
    const Eigen::Vector3d x(0.2, -1.1, 0.7);
    Eigen::Vector3d expected;
    ceres::AngleAxisRotatePoint(phi.data(), x.data(), expected.data());
    EXPECT_LT((Rotate<double>(phi, x) - expected).norm(), 1e-15) << size;
  }
}

TEST(PoseIncrement, MovesBackAndForth) {
  for (const double size : {1.0, 1e-6, 0.0}) {
    const PoseIncrement step = Step(size);
    EXPECT_LT((StepBetween(kPose, Moved(kPose, step)) - step).norm(), 1e-14) << size;
  }
}

// The two quaternions of one rotation are no step apart.
TEST(PoseIncrement, DoesNotCareForTheSignOfAQuaternion) {
  Pose other = Moved(kPose, Step(1.0));
  other.rotation.coeffs() *= -1.0;
  EXPECT_LT((StepBetween(kPose, other) - Step(1.0)).norm(), 1e-14);
}

TEST(PoseIncrement, TransformsPointsOfTheMovedPose) {
  const PoseIncrement step = Step(0.8);
  const Eigen::Vector3d x(0.2, -1.1, 0.7);
  const Pose moved = Moved(kPose, step);
  EXPECT_LT((TransformNear(kPose, step.data(), x) - moved * x).norm(), 1e-14);
  EXPECT_LT((InverseTransformNear(kPose, step.data(), x) - moved.Inverse() * x).norm(), 1e-14);
}

// Also at no step at all, where Rodrigues' formula divides by zero.
TEST(PoseIncrement, HasTheDerivativesOfItsFiniteDifferences) {
  using Jet = ceres::Jet<double, 6>;
  constexpr double kStep = 1e-5;
  const Eigen::Vector3d x(0.2, -1.1, 0.7);
  for (const double size : {0.0, 1e-7, 0.5}) {
    const PoseIncrement at = Step(size);
    Eigen::Matrix<Jet, 6, 1> jets;
    for (int i = 0; i < 6; ++i) jets[i] = Jet(at[i], i);
    const Eigen::Matrix<Jet, 3, 1> x_jet = x.cast<Jet>();
    const auto y = InverseTransformNear<Jet>(kPose, jets.data(), x_jet);
    for (int i = 0; i < 6; ++i) {
      const PoseIncrement h = kStep * PoseIncrement::Unit(i);
      const PoseIncrement up = at + h, down = at - h;
      const Eigen::Vector3d slope = (InverseTransformNear(kPose, up.data(), x) -
                                     InverseTransformNear(kPose, down.data(), x)) /
                                    (2.0 * kStep);
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(y[k].v[i], slope[k], 1e-9) << size;
    }
  }
}

// Monte Carlo: the spread of composed poses. 20000 draws tell a variance to 1 %; 5 of that.
TEST(PoseIncrement, CovarianceOfAComposedPoseIsItsSpread) {
  const Pose b_from_c = {Eigen::Quaterniond(0.6, 0.1, -0.5, 0.4).normalized(), {0.4, 0.7, -0.3}};
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  PoseCovariance root;
  for (double& number : root.reshaped()) number = 1e-4 * normal(random);
  const PoseCovariance covariance = root * root.transpose();
  const PoseCovariance composed = CovarianceOfComposed(kPose, covariance, b_from_c);
  constexpr int kNumDraws = 20000;
  PoseCovariance spread = PoseCovariance::Zero();
  for (int i = 0; i < kNumDraws; ++i) {
    PoseIncrement unit;
    for (double& number : unit) number = normal(random);
    const PoseIncrement step = StepBetween(kPose * b_from_c, Moved(kPose, root * unit) * b_from_c);
    spread += step * step.transpose() / kNumDraws;
  }
  for (int i = 0; i < 6; ++i) {
    for (int k = 0; k < 6; ++k) {
      EXPECT_NEAR(spread(i, k), composed(i, k), 0.05 * std::sqrt(composed(i, i) * composed(k, k)));
    }
  }
}

}  // namespace
}  // namespace fathom
