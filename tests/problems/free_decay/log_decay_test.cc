// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/free_decay/log_decay.h"

#include "fathom/base/input_error.h"
#include "fathom/base/interval95.h"
#include "fathom/free_decay/decay_text.h"

#include <cmath>
#include <random>
#include <utility>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kReleased = 10.0;  // [s]

// A turn of d_L/J 0.2 1/s and d_Q/J 0.48 per rad: driven up to kReleased by what nobody logged,
// then coasting, at 20 Hz with a noise of 0.003 rad/s.
Log TurnLog(double torque = 0.37) {
  Log log;
  log.name = "turn";
  log.path = "turn";
  log.dofs = {Dof::kYaw};
  Stream velocity;
  velocity.columns = {"r"};
  velocity.values.resize(1);
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0.0, 0.003);
  double v = 0.0;
  const int steps_per_sample = 50;
  const double h = 0.05 / steps_per_sample;
  for (int i = 0; i < 440; ++i) {
    const double t = 0.05 * i;
    velocity.time.push_back(t);
    velocity.values[0].push_back(v + noise(random));
    // Euler's steps of 1 ms are off by 1e-4 of the motion, far below the noise.
    for (int k = 0; k < steps_per_sample; ++k) {
      const double drive = t >= 1.5 && t < kReleased ? torque : 0.0;
      v += h * (drive - 0.2 * v - 0.48 * v * std::abs(v));
    }
  }
  log.velocity = std::move(velocity);
  return log;
}

void ExpectTruth(const LogDecay& decay) {
  ASSERT_TRUE(decay.summary.IsUsable()) << decay.summary.message;
  const double truth[] = {0.2, 0.48};
  for (const int rate : {kLinearRate, kQuadraticRate}) {
    const double std = std::sqrt(decay.summary.covariance(rate, rate));
    EXPECT_NEAR(decay.summary.rates[static_cast<std::size_t>(rate)], truth[rate], kStdsOf95 * std);
    EXPECT_LT(std, 0.2 * truth[rate]);
  }
}

TEST(LogDecay, FindsTheDecayOfALogWithoutCommand) {
  const Log log = TurnLog();
  EXPECT_TRUE(IsFreeDecay(log, Dof::kYaw));
  const LogDecay decay = FitLogDecay({&log, 1});
  ExpectTruth(decay);
  ASSERT_EQ(decay.stretches.size(), 1U);
  EXPECT_GE(decay.stretches[0].from, kReleased);
  EXPECT_LT(decay.stretches[0].from, kReleased + 0.5);
  EXPECT_NEAR(decay.stretches[0].to, 21.95, 1e-9);
  EXPECT_FALSE(decay.has_stiffness);
  EXPECT_THAT(FormatDecay(decay), HasSubstr("note: turn: there is no command, so that only"));
}

TEST(LogDecay, FitsCoastDownsOfSeveralLogsTogether) {
  const Log logs[] = {TurnLog(0.37), TurnLog(-0.2)};
  const LogDecay decay = FitLogDecay(logs);
  ExpectTruth(decay);
  EXPECT_EQ(decay.stretches.size(), 2U);
  // The second log tells more: the intervals become narrower.
  const LogDecay alone = FitLogDecay({logs, 1});
  EXPECT_LT(decay.summary.covariance(kLinearRate, kLinearRate),
            alone.summary.covariance(kLinearRate, kLinearRate));
}

TEST(LogDecay, NamesTheConstantTermByItsDof) {
  LogDecay decay;
  const std::pair<Dof, const char*> names[] = {{Dof::kSurge, "constant_force / inertia"},
                                               {Dof::kHeave, "net_buoyancy / inertia"},
                                               {Dof::kYaw, "constant_moment / inertia"}};
  for (const auto& [dof, name] : names) {
    decay.dof = dof;
    EXPECT_EQ(QuantitiesOf(decay).back().name, name);
  }
}

TEST(LogDecay, TakesWhatTheUserSays) {
  const Log log = TurnLog();
  const LogDecay decay = FitLogDecay({&log, 1}, {.from = 12.0});
  ExpectTruth(decay);
  EXPECT_NEAR(decay.stretches.at(0).from, 12.0, 1e-9);
}

// As --held_out has it.
TEST(LogDecay, CountsFromTheFirstSampleOfEpochStamps) {
  Log log = TurnLog();
  for (double& t : log.velocity->time) t += 1.5e9;
  const LogDecay decay = FitLogDecay({&log, 1}, {.from = 12.0});
  ExpectTruth(decay);
  EXPECT_NEAR(decay.stretches.at(0).from, 1.5e9 + 12.0, 1e-6);
  EXPECT_THAT(FormatDecay(decay), HasSubstr("taken from 12 s on, as --decay_from says."));
  EXPECT_THROW(FitLogDecay({&log, 1}, {.from = 30.0}), InputError);
}

// Where there is a command, only what it says counts: here 0 from 15 s on, though the vehicle
// decays from 10 s on.
TEST(LogDecay, TakesOnlyWhereTheCommandIsZero) {
  Log log = TurnLog();
  log.command = Stream{{0.0, 1.5, 15.0}, {"tau_yaw"}, {{0.0, 2.0, 0.0}}};
  EXPECT_FALSE(IsFreeDecay(log, Dof::kYaw));
  const LogDecay decay = FitLogDecay({&log, 1}, {.from = 5.0});
  ASSERT_EQ(decay.stretches.size(), 1U);
  EXPECT_NEAR(decay.stretches[0].from, 15.0, 1e-9);
  log.command->values[0][1] = 0.0;
  EXPECT_TRUE(IsFreeDecay(log, Dof::kYaw));
  log.command->columns = {"tau_surge"};
  EXPECT_FALSE(IsFreeDecay(log, Dof::kYaw));
}

TEST(LogDecay, LeavesHeldOutDataOut) {
  Log log = TurnLog();
  log.held_out = {{15.0, 30.0}};
  const LogDecay decay = FitLogDecay({&log, 1});
  EXPECT_LT(decay.stretches.at(0).to, 15.0);
}

TEST(LogDecay, RefusesALogInWhichNothingDecays) {
  const Log log = TurnLog(0.0);
  const LogDecay decay = FitLogDecay({&log, 1});
  EXPECT_FALSE(decay.summary.IsUsable());
  EXPECT_THAT(decay.summary.message, HasSubstr("Nothing decays"));
}

// Roll with a righting stiffness: the period of small swings is 2 pi / sqrt(c - a^2/4), 3.0 s here.
TEST(LogDecay, FindsTheStiffnessOfARollFromTheSpeedOfTheSwings) {
  const double w = 2.0 * 3.14159265358979 / 3.0, a = 0.2;
  Log log;
  log.path = "roll";
  log.dofs = {Dof::kRoll};
  Stream velocity;
  velocity.columns = {"p"};
  velocity.values.resize(1);
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 0.002);
  for (int i = 0; i < 1000; ++i) {
    const double t = 0.02 * i - 2.0;  // held at 0.3 rad for 2 s
    velocity.time.push_back(0.02 * i);
    const double c = w * w + a * a / 4.0;
    const double speed = t < 0.0 ? 0.0 : -0.3 * c / w * std::exp(-a * t / 2.0) * std::sin(w * t);
    velocity.values[0].push_back(speed + noise(random));
  }
  log.velocity = std::move(velocity);
  const LogDecay decay = FitLogDecay({&log, 1});
  ASSERT_TRUE(decay.summary.IsUsable()) << decay.summary.message;
  EXPECT_TRUE(decay.has_stiffness);
  const double std = std::sqrt(decay.summary.covariance(kStiffnessRate, kStiffnessRate));
  EXPECT_NEAR(decay.summary.rates[kStiffnessRate], w * w + a * a / 4.0, 1.96 * std);
  EXPECT_LT(std, 0.01);
  EXPECT_GT(decay.stretches.at(0).to, 15.0);
  EXPECT_THAT(FormatDecay(decay), HasSubstr("period of small swings: 3 s"));
}

TEST(LogDecay, GivesTheParametersWhereTheInertiaIsKnown) {
  const Log log = TurnLog();
  LogDecay decay = FitLogDecay({&log, 1});
  EXPECT_FALSE(ModelOf(decay).has_value());
  EXPECT_THAT(DecaySentence(decay), HasSubstr("only ratios to the inertia can be known"));
  decay.inertia = 5.45;
  EXPECT_THAT(DecaySentence(decay), Not(HasSubstr("only ratios to the inertia")));
  const auto quantities = QuantitiesOf(decay);
  ASSERT_EQ(quantities.size(), 6U);
  EXPECT_EQ(quantities[3].name, "linear_damping");
  EXPECT_NEAR(quantities[3].value, 5.45 * quantities[0].value, 1e-12);
  EXPECT_NEAR(quantities[4].std, 5.45 * quantities[1].std, 1e-12);
  const auto model = ModelOf(decay);
  ASSERT_TRUE(model.has_value());
  EXPECT_EQ(model->model.inertia, 5.45);
  EXPECT_EQ(model->covariance(0, 0), 0.0);
}

}  // namespace
}  // namespace fathom
