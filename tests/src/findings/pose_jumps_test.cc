// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/pose_jumps.h"

#include "fathom/base/random_stream.h"

#include <cmath>
#include <functional>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

// Two minutes at 10 Hz of x = sin and a yaw that turns several times round, with noise of 3 mm and
// 3 mrad; `x` and `yaw` are added from row to row.
Log WithAdded(const std::function<double(int)>& x, const std::function<double(int)>& yaw) {
  RandomStream noise(1, "pose");
  Stream pose;
  pose.columns = {"x", "y", "z", "qx", "qy", "qz", "qw"};
  pose.values.resize(7);
  for (int k = 0; k < 1200; ++k) {
    const double t = 0.1 * k;
    const double angle = 0.3 * t + yaw(k) + 0.003 * noise.Normal();
    pose.time.push_back(t);
    const double row[] = {std::sin(0.4 * t) + x(k) + 0.003 * noise.Normal(),
                          0.003 * noise.Normal(),
                          0.0,
                          0.0,
                          0.0,
                          std::sin(0.5 * angle),
                          std::cos(0.5 * angle)};
    for (int i = 0; i < 7; ++i) pose.values[i].push_back(row[i]);
  }
  Log log;
  log.pose = pose;
  return log;
}

double Nothing(int) { return 0.0; }

TEST(PoseJumps, AreNotSeenInASmoothPose) {
  EXPECT_THAT(CheckPoseJumps(WithAdded(Nothing, Nothing)), IsEmpty());
}

// Zeros while the tracking was lost.
TEST(PoseJumps, ThatAreManyAreNoRealignment) {
  const auto findings = CheckPoseJumps(
      WithAdded([](int k) { return k % 200 < 20 ? 5.0 : 0.0; }, [](int) { return 0.0; }));
  ASSERT_THAT(findings, SizeIs(1));
  EXPECT_THAT(findings[0].sentence, HasSubstr("x jumps 11 times, most by "));
  EXPECT_THAT(findings[0].sentence,
              EndsWith("So many are no realignment: the tracking was lost "
                       "and found again."));
}

TEST(PoseJumps, OfAnEstimatorThatIsRealignedAreSeen) {
  const auto findings = CheckPoseJumps(WithAdded([](int k) { return k < 400 ? 0.0 : 0.9; },
                                                 [](int k) { return k < 700 ? 0.0 : -0.8; }));
  ASSERT_THAT(findings, SizeIs(2));
  EXPECT_EQ(findings[0].severity, Severity::kWarning);
  EXPECT_THAT(findings[0].sentence, HasSubstr("x jumps once, most by 0.89 m"));
  EXPECT_THAT(findings[0].sentence, HasSubstr("t = 40.00 s"));
  EXPECT_THAT(findings[1].sentence, HasSubstr("yaw jumps once, most by -0."));
}

// A single square has two solutions, and the pose may flip between them.
TEST(PoseJumps, ThatComeBackAreNone) {
  const auto flip = [](int k) { return k % 150 == 20 ? 1.5 : 0.0; };
  EXPECT_THAT(CheckPoseJumps(WithAdded(flip, flip)), IsEmpty());
}

}  // namespace
}  // namespace fathom
