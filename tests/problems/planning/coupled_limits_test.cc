// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_planning/coupled_limits.h"

#include <cmath>
#include <string>
#include <vector>

#include "error_from.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

std::string CoupledRefusalOf(const std::string& text) {
  return ErrorFrom([&] { ParseCoupledLimits("lake.yaml", text); });
}

TEST(CoupledLimits, ReadsEveryKey) {
  const CoupledLimits limits = ParseCoupledLimits(
      "lake.yaml",
      "force: {surge: 40, yaw: 8}\nspeed: {surge: 0.8, yaw: 0.7}\ntilt: 0.3\nheading: 0.6\n"
      "distance: {back: 2, ahead: 3, port: 4, starboard: 5, up: 6, down: 7}\n"
      "shortest_hold: 0.5\nminutes: 2\nvelocity: {rate: 7, noise: {sway: 0.02}}\n");
  EXPECT_EQ(limits.force[0], 40.0);
  EXPECT_EQ(limits.force[1], 0.0);
  EXPECT_EQ(limits.force[5], 8.0);
  EXPECT_EQ(limits.speed[5], 0.7);
  EXPECT_TRUE(std::isinf(limits.speed[1]));
  EXPECT_EQ(limits.tilt, 0.3);
  EXPECT_EQ(limits.heading, 0.6);
  EXPECT_EQ(limits.room[0].low, -2.0);
  EXPECT_EQ(limits.room[1].low, -4.0);
  EXPECT_EQ(limits.room[1].high, 5.0);
  EXPECT_EQ(limits.room[2].high, 7.0);
  EXPECT_EQ(limits.shortest_hold, 0.5);
  EXPECT_EQ(limits.duration, 120.0);
  EXPECT_EQ(limits.rate, 7.0);
  EXPECT_EQ(limits.noise[1], 0.02);
  EXPECT_TRUE(std::isnan(limits.noise[0]));
}

TEST(CoupledLimits, NameFileLineAndKeyOfWhatCannotBe) {
  EXPECT_NE(CoupledRefusalOf("minutes: 2\n").find("key 'force'"), std::string::npos);
  EXPECT_EQ(CoupledRefusalOf("force: 60\n")
                .find("lake.yaml:1: key 'force' is no map, expected a number for each DOF"),
            0U);
  EXPECT_EQ(CoupledRefusalOf("force: {surge: -2}\n").find("lake.yaml:1: key 'force.surge' is "),
            0U);
  EXPECT_NE(CoupledRefusalOf("force: {surge: 2, up: 3}\n").find("up"), std::string::npos);
}

TEST(CoupledLimits, AreBrokenBySpeedRoomTiltAndHeadingAlike) {
  CoupledLimits limits;
  limits.speed[5] = 0.5;
  limits.room[1] = {-1.0, 2.0};
  limits.tilt = 0.3;
  std::vector<CoupledState> run(3);
  EXPECT_TRUE(KeepsLimits(run, limits));
  run[1].nu[5] = -0.51;
  EXPECT_FALSE(KeepsLimits(run, limits));
  run[1].nu[5] = 0.49;
  run[2].position[1] = 1.9;
  EXPECT_TRUE(KeepsLimits(run, limits));
  run[2].position[1] = -1.1;
  EXPECT_FALSE(KeepsLimits(run, limits));
  run[2].position[1] = std::nan("");
  EXPECT_FALSE(KeepsLimits(run, limits));
  run[2] = {.attitude = {std::sin(0.2), 0.0, 0.0, std::cos(0.2)}};
  EXPECT_FALSE(KeepsLimits(run, limits));
  run[2] = {.attitude = {0.0, 0.0, std::sin(-0.35), std::cos(-0.35)}};
  EXPECT_TRUE(KeepsLimits(run, limits));
  limits.heading = 0.6;
  EXPECT_FALSE(KeepsLimits(run, limits));
}

}  // namespace
}  // namespace fathom
