// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/geometry/pose.h"

#include <gtest/gtest.h>

namespace fathom {
namespace {

// Rotations by hand: 90 degrees about z takes x to y, about x takes y to z.
const Eigen::Quaterniond kAboutZ(std::sqrt(0.5), 0.0, 0.0, std::sqrt(0.5));
const Eigen::Quaterniond kAboutX(std::sqrt(0.5), std::sqrt(0.5), 0.0, 0.0);

TEST(Pose, TurnsThenShiftsAPoint) {
  const Pose a_from_b = {kAboutZ, {10.0, 20.0, 30.0}};
  EXPECT_TRUE((a_from_b * Eigen::Vector3d(1.0, 2.0, 3.0)).isApprox(Eigen::Vector3d(8, 21, 33)));
}

TEST(Pose, ComposesByCancellingNeighbours) {
  const Pose a_from_b = {kAboutZ, {10.0, 20.0, 30.0}};
  const Pose b_from_c = {kAboutX, {-1.0, 0.5, 2.0}};
  const Eigen::Vector3d x_c(0.3, -0.7, 1.1);
  EXPECT_TRUE(((a_from_b * b_from_c) * x_c).isApprox(a_from_b * (b_from_c * x_c), 1e-14));
}

TEST(Pose, InverseMapsBack) {
  const Pose a_from_b = {kAboutX * kAboutZ, {1.0, -2.0, 3.0}};
  const Eigen::Vector3d x_b(0.3, -0.7, 1.1);
  EXPECT_TRUE((a_from_b.Inverse() * (a_from_b * x_b)).isApprox(x_b, 1e-14));
}

}  // namespace
}  // namespace fathom
