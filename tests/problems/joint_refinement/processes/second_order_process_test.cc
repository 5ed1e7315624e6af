// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/processes/second_order_process.h"

#include <cmath>

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(SecondOrderProcess, TwoStepsAreOneLongStep) {
  for (const auto& process : {SecondOrderProcess{0.7, 0.3, 2.0},     // weakly damped
                              SecondOrderProcess{0.16, 0.8, 2.0},    // critically
                              SecondOrderProcess{0.4, 40.0, 2.0},    // strongly
                              SecondOrderProcess{0.0, 0.2, 2.0}}) {  // free
    const Transition a = process.Over(0.13), b = process.Over(0.4), both = process.Over(0.53);
    EXPECT_TRUE(both.Phi.isApprox(b.Phi * a.Phi, 1e-10));
    EXPECT_TRUE(both.Q.isApprox(b.Phi * a.Q * b.Phi.transpose() + b.Q, 1e-6));
    const Eigen::Matrix2d I = a.whitener * a.Q * a.whitener.transpose();
    EXPECT_TRUE(I.isIdentity(1e-9));
    EXPECT_NEAR(a.log_det_Q, std::log(a.Q.determinant()), 1e-6);
  }
}

TEST(SecondOrderProcess, StaysAsLargeAsItIs) {
  const SecondOrderProcess process = SecondOrderProcess::Held(0.02, 0.8, 0.6);
  const Eigen::Matrix2d P = process.StationaryCovariance();
  EXPECT_NEAR(P(0, 0), 0.02 * 0.02, 1e-12);
  for (const double h : {0.1, 3.0, 60.0}) {
    const Transition t = process.Over(h);
    EXPECT_TRUE(P.isApprox(t.Phi * P * t.Phi.transpose() + t.Q, 1e-6)) << h;
  }
}

// Of a free particle: Q = q [h^3/3 h^2/2; h^2/2 h] as the damping vanishes.
TEST(SecondOrderProcess, IsTheWellKnownRandomWalkOfAVelocity) {
  const Transition t = SecondOrderProcess{0.0, 1e-9, 3.0}.Over(0.2);
  EXPECT_NEAR(t.Q(0, 0), 3.0 * 0.008 / 3.0, 1e-9);
  EXPECT_NEAR(t.Q(0, 1), 3.0 * 0.04 / 2.0, 1e-9);
  EXPECT_NEAR(t.Q(1, 1), 3.0 * 0.2, 1e-9);
}

}  // namespace
}  // namespace fathom
