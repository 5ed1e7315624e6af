// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/identification/identification.h"

#include <cmath>
#include <random>
#include <vector>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

// 1 m/s for 50 samples, then `later` for 50, under no force.
Segment TwoSpeeds(double later) {
  Segment segment;
  for (int i = 0; i < 100; ++i) {
    segment.time.push_back(0.1 * i);
    segment.velocity.push_back(i < 50 ? 1.0 : later);
  }
  segment.command = {{0.0}, {0.0}};
  segment.initial_velocity = 1.0;
  return segment;
}

// A model without damping goes on at 1 m/s: its NMAE is (1 - later) / (1 + later).
FittedModel Scored(const std::vector<Segment>& train, const std::vector<Segment>& held_out) {
  Signals signals;
  signals.train = train;
  signals.held_out = held_out;
  FittedModel fitted;
  fitted.model = {.inertia = 10.0, .quadratic_damping = 0.0, .linear_damping = 0.0};
  ScoreByFreeRuns(signals, &fitted);
  return fitted;
}

TEST(ScoreByFreeRuns, CallsAFitPoorAboveAnNmaeOfThreeTenthsAndSaysWhatToDo) {
  const FittedModel good = Scored({TwoSpeeds(0.6)}, {});
  EXPECT_NEAR(good.train.nmae, 0.25, 1e-12);
  EXPECT_THAT(good.caveats, IsEmpty());
  const FittedModel poor = Scored({TwoSpeeds(0.5)}, {});
  EXPECT_NEAR(poor.train.nmae, 1.0 / 3.0, 1e-12);
  EXPECT_THAT(poor.caveats,
              ElementsAre(AllOf(HasSubstr("The fit is poor"),
                                HasSubstr("misses 33 % of the motion"),
                                HasSubstr("run fathom_diagnose"))));
}

TEST(ScoreByFreeRuns, SaysThatAModelExplainsAlmostNothing) {
  EXPECT_THAT(Scored({TwoSpeeds(0.1)}, {}).caveats,
              ElementsAre(AllOf(HasSubstr("82 % of the motion"), HasSubstr("almost nothing"))));
}

TEST(ScoreByFreeRuns, SaysThatOnlyTheHeldOutPredictionIsPoor) {
  EXPECT_THAT(Scored({TwoSpeeds(0.9)}, {TwoSpeeds(0.4)}).caveats,
              ElementsAre(HasSubstr("misses 43 % of the held-out motion")));
}

constexpr UncoupledModel<double> kIdentifiedTruth = {
    .inertia = 45.0, .quadratic_damping = 30.0, .linear_damping = 8.0, .buoyancy = 0.5};

// 200 s of poses at 10 Hz of a vehicle that is driven along surge while its heading goes to and fro
// by `turn` [rad]: position with noise of 5 mm, heading with 0.003 rad. Explicit Euler of 0.2 ms,
// the force held for 0.1 s.
Log PosesOfATurningVehicle(double turn) {
  Log log;
  log.path = "turning";
  log.dofs = {Dof::kSurge};
  log.command.emplace();
  log.command->columns = {"tau_surge"};
  log.command->values.resize(1);
  log.pose.emplace();
  log.pose->columns = {"x", "y", "z", "qx", "qy", "qz", "qw"};
  log.pose->values.resize(7);
  std::mt19937 generator(5);
  std::normal_distribution<double> normal;
  const auto heading = [turn](double t) { return turn * std::sin(0.11 * t); };
  double v = 0.0, x = 1.0, y = -2.0;
  for (int i = 0; i <= 2000; ++i) {
    const double t = 0.1 * i;
    const double force = 12.0 * std::sin(0.31 * t + 0.4) + 9.0 * std::sin(1.3 * t + 2.0);
    log.command->time.push_back(t);
    log.command->values[0].push_back(force);
    log.pose->time.push_back(t);
    const double psi = heading(t) + 0.003 * normal(generator);
    const double pose[] = {x + 0.005 * normal(generator),
                           y + 0.005 * normal(generator),
                           0.005 * normal(generator),
                           0.0,
                           0.0,
                           std::sin(0.5 * psi),
                           std::cos(0.5 * psi)};
    for (int k = 0; k < 7; ++k) log.pose->values[k].push_back(pose[k]);
    for (int k = 0; k < 500; ++k) {
      const double now = t + 2e-4 * k;
      x += 2e-4 * v * std::cos(heading(now));
      y += 2e-4 * v * std::sin(heading(now));
      v += 2e-4 * kIdentifiedTruth.Acceleration(v, force);
    }
  }
  return log;
}

// The displacement along any one direction would give an inertia off by tens of percent or worse.
TEST(Identify, TakesTheBodyVelocityOfATurningVehicleFromItsPoses) {
  const Signals signals =
      SignalsOf(PosesOfATurningVehicle(2.0), Dof::kSurge, {.source = Source::kCamera});
  EXPECT_THAT(signals.remarks, Contains(HasSubstr("fitted to the body velocity from the poses")));
  ASSERT_EQ(signals.train.size(), 1);
  EXPECT_THAT(signals.train.front().position, IsEmpty());
  const Identification result = Identify(signals, signals, Family::kOutputError);
  ASSERT_TRUE(result.is_usable) << result.message;
  // Four standard deviations, which are 1.3 % of the inertia at most, and 1 % for the smoothing of
  // the velocity.
  const double std = std::sqrt(result.fitted.covariance(kInertia, kInertia));
  EXPECT_LT(std, 0.013 * kIdentifiedTruth.inertia);
  EXPECT_NEAR(result.fitted.model.inertia,
              kIdentifiedTruth.inertia,
              4.0 * std + 0.01 * kIdentifiedTruth.inertia);
  EXPECT_LT(result.fitted.train.nmae, 0.1);
}

TEST(Identify, FitsThePositionsOfAVehicleThatKeepsItsHeading) {
  const Signals signals =
      SignalsOf(PosesOfATurningVehicle(0.02), Dof::kSurge, {.source = Source::kCamera});
  EXPECT_THAT(signals.remarks, Not(Contains(HasSubstr("axis turns"))));
  ASSERT_EQ(signals.train.size(), 1);
  EXPECT_EQ(signals.train.front().position.size(), signals.train.front().time.size());
  const Identification result = Identify(signals, signals, Family::kOutputError);
  ASSERT_TRUE(result.is_usable) << result.message;
  const double std = std::sqrt(result.fitted.covariance(kInertia, kInertia));
  EXPECT_NEAR(result.fitted.model.inertia, kIdentifiedTruth.inertia, 4.0 * std);
}

}  // namespace
}  // namespace fathom
