// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/rival_separation.h"

#include "fathom/vehicle/effects/catalogue.h"

#include <string>

#include <gtest/gtest.h>

namespace fathom {
namespace {

ExtendedModel WithOne(const std::string& effect, const std::vector<double>& values) {
  ActiveEffect active;
  active.effect = FindEffect(effect);
  active.values = values;
  return WithEffect({{50.0, 30.0, 8.0, 1.5}}, active);
}

// Steps both ways, with a hold after each, of so much force.
HeldCommand Steps(double force) {
  HeldCommand command;
  for (int i = 0; i < 12; ++i) {
    command.time.push_back(5.0 * i);
    command.value.push_back(force * (i % 4 == 0 ? 1.0 : i % 4 == 2 ? -0.6 : 0.2));
  }
  return command;
}

TEST(RivalSeparation, OfTheTruthFromItselfIsNone) {
  const std::vector<double> stamps = PlannedStamps(60.0, 0.1);
  const RunSetting setting = {Dof::kSurge, Steps(20.0), stamps, {0.01}};
  const ExtendedModel lag = WithOne("thruster_lag", {0.4});
  const auto motion = MotionUnder(lag, Dof::kSurge, setting.command, stamps);
  ASSERT_TRUE(motion);
  // Also from another start of the refit.
  EXPECT_LT(RefitTo(*motion, WithOne("thruster_lag", {0.3}), setting).sigmas, 0.01);
  EXPECT_NEAR(RefitTo(*motion, WithOne("thruster_lag", {0.3}), setting).model.effects[0].values[0],
              0.4,
              1e-3);
}

TEST(RivalSeparation, IsInStandardDeviationsOfTheNoise) {
  const std::vector<double> stamps = PlannedStamps(60.0, 0.1);
  const ExtendedModel lag = WithOne("thruster_lag", {0.4});
  const ExtendedModel delay = WithOne("time_offset", {0.4});
  const auto motion = MotionUnder(lag, Dof::kSurge, Steps(20.0), stamps);
  ASSERT_TRUE(motion);
  const double at_one = RefitTo(*motion, delay, {Dof::kSurge, Steps(20.0), stamps, {0.01}}).sigmas;
  const double at_two = RefitTo(*motion, delay, {Dof::kSurge, Steps(20.0), stamps, {0.02}}).sigmas;
  EXPECT_GT(at_one, 5.0);
  EXPECT_NEAR(at_one / at_two, 2.0, 1e-9);
}

// Two lags in a row can be exchanged where the drag is linear, which it is at small speeds.
TEST(RivalSeparation, OfThrusterLagAndSensorLagNeedsLargeSpeeds) {
  const std::vector<double> stamps = PlannedStamps(60.0, 0.1);
  const ExtendedModel thruster = WithOne("thruster_lag", {0.4});
  const ExtendedModel sensor = WithOne("sensor_lag", {0.4});
  double sigmas[2];
  for (int i = 0; i < 2; ++i) {
    const RunSetting setting = {Dof::kSurge, Steps(i == 0 ? 2.0 : 60.0), stamps, {0.01}};
    const auto motion = MotionUnder(thruster, Dof::kSurge, setting.command, stamps);
    ASSERT_TRUE(motion);
    sigmas[i] = RefitTo(*motion, sensor, setting).sigmas;
  }
  EXPECT_LT(sigmas[0], 0.2);
  EXPECT_GT(sigmas[1], 20.0 * sigmas[0]);
}

// With w = v - c the equation of a current is that of still water, and v = w + c that of a biased
// sensor: with the start free, no velocity tells them apart, whatever is driven. The refit frees
// the start to first order only; what that leaves is below one standard deviation here.
TEST(RivalSeparation, OfACurrentFromABiasNeedsPositions) {
  const std::vector<double> stamps = PlannedStamps(60.0, 0.1);
  RunSetting setting = {Dof::kSurge, Steps(20.0), stamps, {0.01}};
  const auto motion =
      MotionUnder(WithOne("steady_current", {0.05}), Dof::kSurge, setting.command, stamps);
  ASSERT_TRUE(motion);
  for (const double start : {0.0, 0.2, -0.3}) {
    EXPECT_LT(RefitTo(*motion, WithOne("sensor_bias", {start}), setting).sigmas, 1.0) << start;
  }
  // 0.05 m/s of bias are 3 m in a minute.
  setting.noise.position = 0.02;
  EXPECT_GT(RefitTo(*motion, WithOne("sensor_bias", {0.05}), setting).sigmas, 10.0);
}

TEST(RivalSeparation, OfThrusterLagAndSensorLagIsTheShiftOfThePositions) {
  const std::vector<double> stamps = PlannedStamps(60.0, 0.1);
  RunSetting setting = {Dof::kSurge, Steps(20.0), stamps, {0.01}};
  const auto motion =
      MotionUnder(WithOne("thruster_lag", {0.4}), Dof::kSurge, setting.command, stamps);
  ASSERT_TRUE(motion);
  const ExtendedModel sensor = WithOne("sensor_lag", {0.4});
  const double by_velocity = RefitTo(*motion, sensor, setting).sigmas;
  setting.noise.position = 0.01;
  // Readings that agree leave true speeds that differ in time by 0.4 s: 8 cm at 0.2 m/s.
  EXPECT_LT(by_velocity, 5.0);
  EXPECT_GT(RefitTo(*motion, sensor, setting).sigmas, 10.0);
}

TEST(RivalSeparation, IsFoundByOneStepWhereModelsAreNear) {
  const std::vector<double> stamps = PlannedStamps(60.0, 0.1);
  const RunSetting setting = {Dof::kSurge, Steps(20.0), stamps, {0.01}};
  const std::vector<RivalModel> rivals = {{"thruster_lag", WithOne("thruster_lag", {0.4})},
                                          {"time_offset", WithOne("time_offset", {0.4})}};
  const std::vector<double> quick = QuickSeparations(rivals, setting);
  ASSERT_EQ(quick.size(), 2U);
  const auto motion = MotionUnder(rivals[0].model, Dof::kSurge, setting.command, stamps);
  EXPECT_NEAR(quick[0] / RefitTo(*motion, rivals[1].model, setting).sigmas, 1.0, 0.1);
}

}  // namespace
}  // namespace fathom
