// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/coupled/coupled_data.h"

#include "fathom/base/input_error.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include <gmock/gmock.h>

namespace fathom {
namespace {

// 10 Hz for 30 s: u rises by 0.01 m/s a second, yaw turns at 0.1 rad/s; a gap from 20 to 25 s.
Log SmallLog() {
  Log log;
  log.name = "small";
  log.command.emplace();
  log.command->time = {1.0, 5.0};
  log.command->columns = {"tau_surge"};
  log.command->values = {{2.0, -1.0}};
  log.velocity.emplace();
  log.velocity->columns = {"u"};
  log.velocity->values.resize(1);
  log.pose.emplace();
  log.pose->columns = {"qx", "qy", "qz", "qw"};
  log.pose->values.resize(4);
  for (int i = 0; i <= 300; ++i) {
    const double t = 0.1 * i;
    if (t > 20.05 && t < 24.95) continue;
    log.velocity->time.push_back(t);
    log.velocity->values[0].push_back(0.01 * t);
    log.pose->time.push_back(t);
    const double half = 0.05 * t;
    const double q[4] = {0.0, 0.0, std::sin(half), std::cos(half)};
    for (std::size_t k = 0; k < 4; ++k) log.pose->values[k].push_back(q[k]);
  }
  return log;
}

TEST(CoupledDataOf, CutsAtGapsAndBeforeTheFirstCommand) {
  const CoupledData data = CoupledDataOf(SmallLog(), {Dof::kSurge, Dof::kYaw});
  ASSERT_EQ(data.segments.size(), 2u);
  EXPECT_NEAR(data.segments[0].time.front(), 1.0, 1e-9);
  EXPECT_NEAR(data.segments[0].time.back(), 20.0, 1e-9);
  EXPECT_NEAR(data.segments[1].time.front(), 25.0, 1e-9);
  EXPECT_EQ(data.remarks.size(), 1u);
}

TEST(CoupledDataOf, TakesFromThePosesWhatTheVelocitiesLack) {
  const CoupledData data = CoupledDataOf(SmallLog(), {Dof::kSurge, Dof::kYaw});
  EXPECT_TRUE(data.has_velocity[0]);
  EXPECT_FALSE(data.has_velocity[5]);
  EXPECT_TRUE(data.has_attitude);
  const CoupledState state = MeasuredState(data.segments[0], 100);
  EXPECT_NEAR(state.nu[0], 0.01 * data.segments[0].time[100], 1e-9);
  EXPECT_NEAR(state.nu[5], 0.1, 1e-6);
  EXPECT_NEAR(
      std::atan2(state.attitude[2], state.attitude[3]), 0.05 * data.segments[0].time[100], 1e-6);
}

TEST(CoupledDataOf, RefusesALogThatLacksWhatIsAsked) {
  EXPECT_THROW(CoupledDataOf(SmallLog(), {Dof::kSurge, Dof::kHeave}), InputError);
  EXPECT_THROW(CoupledDataOf(SmallLog(), {Dof::kYaw}), InputError);  // nothing turns it
}

TEST(CoupledDataOf, KeepsTheThrusters) {
  Log log = SmallLog();
  log.thrusters.emplace();
  log.thrusters->time = log.command->time;
  log.thrusters->columns = {"thruster_1"};
  log.thrusters->values = {{2.0, -1.0}};
  Thruster thruster;
  thruster.name = "port";
  thruster.position = {0.0, -0.5, 0.0};
  const CoupledData data = CoupledDataOf(log, {Dof::kSurge, Dof::kYaw}, {{thruster}});
  ASSERT_EQ(data.inputs.command.thrusters.size(), 1u);
  const CommandedThruster& commanded = data.inputs.command.thrusters.front();
  EXPECT_EQ(commanded.name, "port");
  EXPECT_EQ(commanded.push[0], 1.0);
  EXPECT_EQ(commanded.push[5], 0.5);  // on the port side, forwards: it turns to starboard
  EXPECT_TRUE(data.inputs.command.force.empty());
}

TEST(CoupledDataOf, KeepsTheFinsAndRefusesDegrees) {
  Log log = SmallLog();
  Fin rudder;
  rudder.name = "rudder";
  rudder.largest_angle = 0.3;
  log.fins = Stream{log.command->time, {"fin_rudder"}, {}};
  log.fins->values.push_back(std::vector<double>(log.command->time.size(), 0.35));
  const CoupledData data = CoupledDataOf(log, {Dof::kSurge}, {}, {{rudder}});
  ASSERT_EQ(data.inputs.command.fins.size(), 1u);
  EXPECT_EQ(data.inputs.command.fins[0].angle[0], 0.35);
  EXPECT_THAT(data.remarks, testing::Contains(testing::HasSubstr("beyond the 0.3 rad")));
  EXPECT_THROW(CoupledDataOf(log, {Dof::kSurge}), InputError);  // the vehicle has no such fin
  log.fins->values[0][0] = 20.0;
  EXPECT_THROW(CoupledDataOf(log, {Dof::kSurge}, {}, {{rudder}}), InputError);
}

TEST(WindowsOf, CutsInPartsOfOneLength) {
  const CoupledData data = CoupledDataOf(SmallLog(), {Dof::kSurge});
  const std::vector<SampleWindow> windows = WindowsOf(data.segments[0], 5.0);
  ASSERT_EQ(windows.size(), 4u);
  EXPECT_EQ(windows.front().begin, 0u);
  for (std::size_t k = 1; k < windows.size(); ++k) EXPECT_EQ(windows[k].begin, windows[k - 1].end);
  EXPECT_EQ(windows.back().end, data.segments[0].time.size());
  EXPECT_EQ(WindowsOf(data.segments[0], 15.0).size(), 1u);
}

TEST(WindowsOf, HoldsEverySampleHoweverShortTheWindows) {
  CoupledSegment segment = CoupledDataOf(SmallLog(), {Dof::kSurge}).segments[0];
  segment.time[1] = segment.time[0] + 1e-9;  // a step that holds no second sample
  for (const double length : {1e-300, 1e-3, 0.1, 0.15, 0.25}) {
    std::size_t next = 0;
    for (const SampleWindow& window : WindowsOf(segment, length)) {
      EXPECT_EQ(window.begin, next);
      EXPECT_GE(window.end, window.begin + 2);
      next = window.end;
    }
    EXPECT_EQ(next, segment.time.size());
  }
}

}  // namespace
}  // namespace fathom
