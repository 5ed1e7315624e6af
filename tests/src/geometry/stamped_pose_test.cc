// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/geometry/stamped_pose.h"

#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;

std::vector<StampedPose> TwoPoses() {
  StampedPose first = {.time = 0.5,
                       .pose = {Eigen::Quaterniond(0.8, 0.0, 0.6, 0.0), {1.0, 2.0, 3.0}},
                       .covariance = Eigen::Matrix<double, 6, 6>::Identity()};
  first.covariance.diagonal() << 0.01, 0.04, 0.09, 0.16, 0.25, 0.36;
  StampedPose second = first;
  second.time = 0.6;
  return {first, second};
}

TEST(StampedPose, BecomesAStreamWithStandardDeviations) {
  const Stream stream = PoseStreamOf(TwoPoses());
  EXPECT_THAT(stream.time, ElementsAre(0.5, 0.6));
  EXPECT_THAT(
      stream.columns,
      ElementsAre(
          "x", "y", "z", "qx", "qy", "qz", "qw", "sx", "sy", "sz", "sroll", "spitch", "syaw"));
  EXPECT_EQ((*stream.Find("z"))[0], 3.0);
  EXPECT_EQ((*stream.Find("qy"))[1], 0.6);
  EXPECT_EQ((*stream.Find("qw"))[1], 0.8);
  EXPECT_DOUBLE_EQ((*stream.Find("sz"))[0], 0.3);
  EXPECT_DOUBLE_EQ((*stream.Find("syaw"))[0], 0.6);
}

TEST(StampedPose, LeavesOutDeviationsThatOnePoseDoesNotHave) {
  std::vector<StampedPose> poses = TwoPoses();
  poses[1].covariance = StampedPose().covariance;
  EXPECT_EQ(PoseStreamOf(poses).columns.size(), 7u);
}

}  // namespace
}  // namespace fathom
