// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/plan_limits.h"

#include <cmath>
#include <string>

#include "error_from.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

// What is said of a text that cannot be used.
std::string RefusalOf(const std::string& text) {
  return ErrorFrom([&] { ParsePlanLimits("tank.yaml", text); });
}

TEST(PlanLimits, ReadsEveryKey) {
  const PlanLimits limits = ParsePlanLimits("tank.yaml",
                                            "force: 60\nspeed: 0.6\n"
                                            "distance: {back: 3, ahead: 5}\nshortest_hold: 0.5\n"
                                            "minutes: 2\nvelocity: {rate: 7, noise: 0.02}\n"
                                            "position: {rate: 3, noise: 0.04}\n");
  EXPECT_EQ(limits.force, 60.0);
  EXPECT_EQ(limits.speed, 0.6);
  EXPECT_EQ(limits.distance.low, -3.0);
  EXPECT_EQ(limits.distance.high, 5.0);
  EXPECT_EQ(limits.shortest_hold, 0.5);
  EXPECT_EQ(limits.duration, 120.0);
  EXPECT_EQ(limits.velocity.rate, 7.0);
  EXPECT_EQ(limits.velocity.noise, 0.02);
  EXPECT_EQ(limits.position.rate, 3.0);
  EXPECT_EQ(limits.position.noise, 0.04);
}

TEST(PlanLimits, AreOpenWhereNothingIsSaid) {
  const PlanLimits limits = ParsePlanLimits("sea.yaml", "force: 60\ndistance: {back: 3}\n");
  EXPECT_EQ(limits.speed, PlanLimits::kNoLimit);
  EXPECT_EQ(limits.distance.low, -3.0);
  EXPECT_EQ(limits.distance.high, PlanLimits::kNoLimit);
  EXPECT_FALSE(limits.duration);
  EXPECT_TRUE(std::isnan(limits.velocity.rate));
  EXPECT_TRUE(std::isinf(limits.position.noise));
}

TEST(PlanLimits, NameFileLineAndKeyOfWhatCannotBe) {
  EXPECT_EQ(RefusalOf("speed: 1\n").find("tank.yaml:1: key 'force' is missing"), 0U);
  EXPECT_EQ(RefusalOf("force: 5\nspeed: -1\n").find("tank.yaml:2: key 'speed' is "), 0U);
  EXPECT_EQ(
      RefusalOf("force: 5\ndistance: {ahead: 0}\n").find("tank.yaml:2: key 'distance.ahead' is "),
      0U);
  EXPECT_EQ(RefusalOf("force: 5\ndistance: 8\n")
                .find("tank.yaml:2: key 'distance' is one value, expected one each way"),
            0U);
  EXPECT_NE(RefusalOf("force: 5\nspede: 1\n").find("spede"), std::string::npos);
}

// force: {surge: 40} is of several.
TEST(PlanLimits, SayThatTheModelHasOneDof) {
  const std::string refusal = RefusalOf("force: {surge: 40, yaw: 8}\nspeed: {surge: 0.8}\n");
  EXPECT_EQ(refusal.find("tank.yaml:1: key 'force' is a map, as for a model of several DOFs"), 0U)
      << refusal;
  EXPECT_NE(refusal.find("the model has one DOF"), std::string::npos);
  EXPECT_NE(refusal.find("holds force: 40, speed: 0.8"), std::string::npos);
}

}  // namespace
}  // namespace fathom
