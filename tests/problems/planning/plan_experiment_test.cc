// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/plan_experiment.h"

#include "fathom/base/input_error.h"
#include "fathom/planning/plan_files.h"

#include <algorithm>
#include <cmath>

#include "error_from.h"
#include "tank_trial.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

constexpr double kMinute = 60.0;
constexpr double kPlanned = 2.0 * kMinute;  // duration [s]
constexpr double kEffortOfTest = 0.25;      // a plan in half a second

double Weakest(const TankVehicle& vehicle, const FittedModel& fitted) {
  if (std::isnan(fitted.model.inertia)) return std::numeric_limits<double>::infinity();
  const std::vector<double> stds = RelativeStds(fitted, vehicle);
  return *std::max_element(stds.begin(), stds.end());
}

double WeakestBy(const TankVehicle& vehicle, const HeldCommand& command) {
  const TrueRun run = RunTruth(vehicle.truth, command, kPlanned);
  return Weakest(vehicle, FitTankLog(MeasuredRun(run, command, 7)));
}

FittedModel AfterSine(const TankVehicle& vehicle, std::uint64_t seed, double correlation = 0.0) {
  const HeldCommand sine = LargestSine(vehicle, kPlanned);
  return FitTankLog(MeasuredRun(RunTruth(vehicle.truth, sine, kPlanned), sine, seed, correlation));
}

// 1e11 samples a second.
TEST(PlanExperiment, RefusesARateThatNoLogHas) {
  PlanRequest request;
  request.name = "m.json";
  request.model.train = {.mae = 0.01, .nmae = 0.05, .num_samples = 100, .duration = 1e-9};
  EXPECT_EQ(ErrorFrom([&] { MeasurementOf(request); }),
            "m.json: does not say how often its log measured the velocity, expected `velocity: "
            "{rate: 10}` in the limits file.");
}

class DrawnVehicle : public ::testing::TestWithParam<int> {};

// The promises of docs/plan.md on vehicles whose truth the plan does not know.
TEST_P(DrawnVehicle, IsKnownBestByItsPlannedExperiment) {
  const auto seed = static_cast<std::uint64_t>(GetParam());
  const TankVehicle vehicle = DrawTankVehicle(seed);
  const ExperimentPlan plan =
      PlanInTank(vehicle, AfterSine(vehicle, seed), kPlanned, kEffortOfTest);
  ASSERT_TRUE(plan.IsUsable()) << plan.message;

  const TrueRun run = RunTruth(vehicle.truth, plan.command, kPlanned);
  // Also while it coasts behind the command.
  EXPECT_TRUE(
      KeepsTankLimits(RunTruth(vehicle.truth, plan.command, kPlanned + 10.0), vehicle.limits));
  EXPECT_LE(plan.share_breaking, 0.01);

  const FittedModel fitted = FitTankLog(MeasuredRun(run, plan.command, seed + 100));
  for (int i = 0; i < kNumParameters; ++i) {
    const double measured = std::sqrt(fitted.covariance(i, i));
    EXPECT_NEAR(measured / plan.parameters[i].after, 1.0, 0.2) << plan.parameters[i].name;
  }

  const double planned = Weakest(vehicle, fitted);
  double best_steps = std::numeric_limits<double>::infinity();
  for (std::uint64_t i = 0; i < 40; ++i) {
    best_steps = std::min(best_steps, WeakestBy(vehicle, RandomSteps(vehicle, kPlanned, i)));
  }
  EXPECT_LE(planned, 0.8 * best_steps);
  EXPECT_LE(planned, WeakestBy(vehicle, LargestSine(vehicle, kPlanned)) / 3.0);
}

INSTANTIATE_TEST_SUITE_P(Seeds, DrawnVehicle, ::testing::Values(4, 13));

// The heaviest of twenty drawn vehicles: its sine leaves the quadratic damping open, the fit ends
// at 0 with a colour of eleven terms. With that model and that colour the fits report 1.34 times as
// much as forecast.
TEST(PlanExperiment, ForecastsWhatTheLogAllowsWhereTheFitEndsAtABound) {
  const double correlation = 0.8;
  const TankVehicle vehicle = DrawTankVehicle(2);
  const FittedModel so_far = AfterSine(vehicle, 2, correlation);
  ASSERT_LT(so_far.model.quadratic_damping, 0.05 * vehicle.truth.quadratic_damping);
  ASSERT_GT(so_far.residual_autoregression->size(), 5U);
  const ExperimentPlan plan = PlanInTank(vehicle, so_far, kPlanned, kEffortOfTest);
  ASSERT_TRUE(plan.IsUsable()) << plan.message;
  const TrueRun run = RunTruth(vehicle.truth, plan.command, kPlanned);
  constexpr int kRepeats = 8;
  ParameterVector variances = ParameterVector::Zero();
  for (std::uint64_t i = 0; i < kRepeats; ++i) {
    const FittedModel fitted = FitTankLog(MeasuredRun(run, plan.command, 1000 + i, correlation));
    variances += fitted.covariance.diagonal() / kRepeats;
  }
  for (int p = 0; p < kNumParameters; ++p) {
    EXPECT_NEAR(std::sqrt(variances[p]) / plan.parameters[p].after, 1.0, 0.2)
        << plan.parameters[p].name;
  }
}

TEST(PlanExperiment, IsTheSameToTheBitForTheSameSeed) {
  const TankVehicle vehicle = DrawTankVehicle(5);
  PlanRequest request;
  request.model = AfterSine(vehicle, 5);
  request.name = "sine.json";
  request.limits = vehicle.limits;
  request.duration = kMinute;
  request.effort = kEffortOfTest;
  const ExperimentPlan first = PlanExperiment(request), second = PlanExperiment(request);
  EXPECT_EQ(FormatPlan(request, first), FormatPlan(request, second));
  EXPECT_EQ(first.command.value, second.command.value);
  request.seed = 2;
  EXPECT_NE(PlanExperiment(request).command.value, first.command.value);
}

// Four times as many velocities of twice the noise tell as much.
TEST(PlanExperiment, CountsHowOftenTheVelocityIsMeasured) {
  TankVehicle vehicle = DrawTankVehicle(5);
  const FittedModel so_far = AfterSine(vehicle, 5);
  vehicle.limits.velocity = {10.0, 0.01};
  const ExperimentPlan seldom = PlanInTank(vehicle, so_far, kMinute, 0.05);
  vehicle.limits.velocity = {40.0, 0.02};
  const ExperimentPlan often = PlanInTank(vehicle, so_far, kMinute, 0.05);
  for (int i = 0; i < kNumParameters; ++i) {
    EXPECT_NEAR(often.parameters[i].after / seldom.parameters[i].after, 1.0, 1e-6);
  }
}

// The speed has its peaks where the command changes, and a sensor of one sample in two seconds sees
// few of them.
TEST(PlanExperiment, KeepsTheLimitsBetweenTheSamplesOfASlowSensor) {
  TankVehicle vehicle = DrawTankVehicle(5);
  const FittedModel so_far = AfterSine(vehicle, 5);
  vehicle.limits.velocity = {0.5, 0.01};
  const ExperimentPlan plan = PlanInTank(vehicle, so_far, kMinute, 0.05);
  ASSERT_TRUE(plan.IsUsable());
  PlanLimits limits = vehicle.limits;
  limits.speed += 1e-3;
  EXPECT_TRUE(KeepsTankLimits(RunTruth(so_far.model, plan.command, kMinute + 10.0), limits));
}

TEST(PlanExperiment, SaysThatNoCommandKeepsTheLimits) {
  // One millimetre either way: the unknown offset alone carries every vehicle out.
  TankVehicle vehicle = DrawTankVehicle(5);
  vehicle.limits.distance = {-0.001, 0.001};
  const ExperimentPlan plan = PlanInTank(vehicle, AfterSine(DrawTankVehicle(5), 5), kMinute);
  EXPECT_FALSE(plan.IsUsable());
  EXPECT_NE(plan.message.find("keeps the limits"), std::string::npos);
}

TEST(PlanExperiment, RefusesAModelOfUnknownCovarianceOrNoise) {
  const TankVehicle vehicle = DrawTankVehicle(5);
  FittedModel model = AfterSine(vehicle, 5);
  model.train = {};
  EXPECT_THROW(PlanInTank(vehicle, model, kMinute), InputError);
  model = AfterSine(vehicle, 5);
  model.covariance(1, 1) = std::nan("");
  EXPECT_THROW(PlanInTank(vehicle, model, kMinute), InputError);
  model = AfterSine(vehicle, 5);
  model.force_unit = "A";
  EXPECT_THROW(PlanInTank(vehicle, model, kMinute), InputError);
}

}  // namespace
}  // namespace fathom
