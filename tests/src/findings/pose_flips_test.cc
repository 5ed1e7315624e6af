// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/pose_flips.h"

#include "fathom/base/random_stream.h"
#include "fathom/log/read_log.h"

#include <cmath>
#include <functional>
#include <set>

#include "real_data.h"
#include <fmt/format.h>
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// A minute at 30 Hz of a vehicle that turns to and fro at up to 1 rad/s, with noise of 3 mrad;
// `yaw` is added from row to row.
Log Turning(const std::function<double(int)>& yaw) {
  RandomStream noise(1, "flips");
  Log log;
  log.pose = Stream{{}, {"x", "y", "z", "qx", "qy", "qz", "qw"}, {}};
  log.pose->values.resize(7);
  for (int k = 0; k < 1800; ++k) {
    const double t = k / 30.0;
    const double angle = 2.0 * std::sin(0.5 * t) + yaw(k) + 0.003 * noise.Normal();
    log.pose->time.push_back(t);
    const double row[] = {0.1 * t, 0.0, 0.0, 0.0, 0.0, std::sin(angle / 2), std::cos(angle / 2)};
    for (int i = 0; i < 7; ++i) log.pose->values[i].push_back(row[i]);
  }
  return log;
}

TEST(PoseFlips, AreNotSeenInATurningVehicle) {
  EXPECT_FALSE(CheckPoseFlips(Turning([](int) { return 0.0; })));
}

TEST(PoseFlips, AreSeenWhereTheAttitudeComesBack) {
  const auto finding = CheckPoseFlips(Turning([](int k) {
    return k == 600 ? 0.5 * M_PI : k >= 900 && k < 903 ? M_PI : 0.0;
  }));
  ASSERT_TRUE(finding.has_value());
  EXPECT_EQ(finding->code, "pose_flip");
  EXPECT_THAT(finding->sentence, HasSubstr("turns away and back 2 times, first by 89°"));
  EXPECT_THAT(finding->sentence, HasSubstr("at t = 20.00 s"));
  ASSERT_TRUE(finding->where.has_value());
  EXPECT_DOUBLE_EQ(finding->where->time.from, 20.0);
  EXPECT_DOUBLE_EQ(finding->where->time.to, 20.0);
}

TEST(PoseFlips, AreBlamedOnMarkersOnlyWhereThereAreSome) {
  Log log = Turning([](int k) { return k == 600 ? 0.5 * M_PI : 0.0; });
  EXPECT_THAT(CheckPoseFlips(log)->sentence, Not(HasSubstr("marker")));
  log.detections.emplace();
  EXPECT_THAT(CheckPoseFlips(log)->sentence, HasSubstr("A single marker that is small"));
}

// pose_jumps.h tells those.
TEST(PoseFlips, AreNoneWhereTheAttitudeStaysAway) {
  EXPECT_FALSE(CheckPoseFlips(Turning([](int k) { return k < 600 ? 0.0 : 0.5 * M_PI; })));
}

// SPOILERS.md of the boat counts them.
using PoseFlipsOfRealLogs = OnRealData;

TEST_F(PoseFlipsOfRealLogs, AreThoseThatAreKnown) {
  const std::set<int> known = {2, 8, 10, 13, 20, 26, 28, 33, 35, 46, 48, 56, 61, 64, 66};
  for (int run = 1; run <= 72; ++run) {
    const Log log = ReadLog(folder_ / fmt::format("boat_archive/run_{:03}", run));
    EXPECT_EQ(CheckPoseFlips(log).has_value(), known.contains(run)) << run;
  }
}

}  // namespace
}  // namespace fathom
