// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/effect_simulation.h"

#include "fathom/vehicle/effects/catalogue.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "square_root_drag.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

const UncoupledModel<double> kSurge = {890.0, 60.0, 39.0, -0.8};

// 120 s: a command at 10 Hz of two tones and steps, velocities at stamps of their own, poses at
// others, and motion of the other DOFs.
EffectInputs Inputs() {
  EffectInputs inputs;
  for (int i = 0; i < 1200; ++i) {
    const double t = 100.0 + 0.1 * i;
    const double step = std::fmod(t, 40.0) < 20.0 ? 25.0 : -15.0;
    inputs.command.time.push_back(t);
    inputs.command.value.push_back(step + 40.0 * std::sin(0.3 * t) + 10.0 * std::sin(1.7 * t));
  }
  for (const Dof dof : kAllDofs) {
    const double rate = 0.2 + 0.1 * Index(dof);
    for (int i = 0; i < 2400; ++i) {
      const double t = 100.0 + 0.05 * i;
      inputs.velocity[Index(dof)].time.push_back(t);
      inputs.velocity[Index(dof)].value.push_back(0.1 * std::sin(rate * t));
      if (i % 2 == 0) {
        inputs.force[Index(dof)].time.push_back(t);
        inputs.force[Index(dof)].value.push_back(20.0 * std::cos(rate * t));
      }
    }
  }
  return inputs;
}

OutputStamps Stamps() {
  OutputStamps stamps;
  stamps.start = 101.03;
  for (int i = 0; i < 1100; ++i) stamps.velocity.push_back(101.03 + 0.1 * i + 0.003 * (i % 7));
  for (int i = 0; i < 500; ++i) stamps.displacement.push_back(101.2 + 0.2 * i);
  return stamps;
}

// Values of an effect that change the run by a good part.
std::vector<double> TypicalValues(const EffectInfo& info) {
  std::vector<double> values;
  for (const EffectParameter& parameter : info.parameters) {
    const Quantity& quantity = parameter.quantity;
    double value = std::pow(30.0, quantity.force) * std::pow(0.3, quantity.speed);
    if (parameter.search == Search::kAmount) value *= 0.3;
    if (parameter.search == Search::kTimeOfRun) value = 40.033;
    if (parameter.search == Search::kFrequencyOfRun) value = 0.7;
    if (parameter.name == "rate" && quantity.force == 0.0) value = 0.004;
    if (parameter.name == "slope") value = 0.1;
    if (parameter.name == "limit") value = 45.0;
    if (parameter.name == "exponent") value = 1.4;
    if (parameter.quantity.time > 0.0 && parameter.search == Search::kSize) value = 0.437;
    values.push_back(value);
  }
  return values;
}

class EveryEffect : public testing::TestWithParam<const Effect*> {
 protected:
  ExtendedModel ModelWith(const std::vector<double>& values) const {
    const bool may_be_sway = CanBePartner(GetParam()->info(), Dof::kSurge, Dof::kSway);
    const Dof partner = may_be_sway ? Dof::kSway : Dof::kYaw;
    return {kSurge, {{GetParam(), {Dof::kSurge, partner, 37.0}, values}}};
  }
};

double Spread(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0.0;
  for (size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

TEST_P(EveryEffect, IsTheBaselineAtItsNull) {
  const EffectInputs inputs = Inputs();
  const EffectSimulation simulation(&inputs, Stamps());
  std::vector<double> null;
  for (const EffectParameter& parameter : GetParam()->info().parameters) {
    null.push_back(std::isnan(parameter.null) ? 30.0 : parameter.null);
  }
  EffectOutputs baseline, nested, typical;
  ASSERT_TRUE(simulation.Run({kSurge, {}}, {0.1, 2.0}, &baseline));
  ASSERT_TRUE(simulation.Run(ModelWith(null), {0.1, 2.0}, &nested));
  ASSERT_TRUE(simulation.Run(ModelWith(TypicalValues(GetParam()->info())), {0.1, 2.0}, &typical));
  // What an effect adds at its null is rounding; or that its steps are divided otherwise.
  EXPECT_LT(Spread(baseline.velocity, nested.velocity), 1e-7);
  EXPECT_LT(Spread(baseline.displacement, nested.displacement), 1e-7);
  EXPECT_GT(Spread(baseline.velocity, typical.velocity) +
                Spread(baseline.displacement, typical.displacement),
            1e-3);
}

TEST_P(EveryEffect, HasTheDerivativesOfItsFiniteDifferences) {
  const EffectInputs inputs = Inputs();
  const EffectSimulation simulation(&inputs, Stamps());
  const std::vector<double> values = TypicalValues(GetParam()->info());
  const InitialState initial = {0.1, 2.0, 0.07, -0.04};
  EffectOutputs at;
  ASSERT_TRUE(simulation.RunWithSensitivities(ModelWith(values), initial, &at));
  EffectOutputs plain;
  ASSERT_TRUE(simulation.Run(ModelWith(values), initial, &plain));
  EXPECT_LT(Spread(at.velocity, plain.velocity), 1e-12);
  const int num_columns = EffectSimulation::NumColumns(ModelWith(values));
  ASSERT_EQ(at.velocity_sensitivity.cols(), num_columns);
  const auto excesses = EffectSimulation::ExcessesOf(ModelWith(values));
  for (int column = 0; column < num_columns; ++column) {
    EffectOutputs outputs[2];
    double step = 0.0;
    for (const int side : {0, 1}) {
      ExtendedModel model = ModelWith(values);
      InitialState start = initial;
      double* const places[] = {&model.baseline.inertia,
                                &model.baseline.quadratic_damping,
                                &model.baseline.linear_damping,
                                &model.baseline.buoyancy,
                                &start.velocity,
                                &start.position};
      double* const place = column < 6 ? places[column]
                            : column < 6 + static_cast<int>(values.size())
                                ? &model.effects[0].values[column - 6]
                                : &(start.*excesses.at(column - 6 - values.size()));
      step = 1e-5 * std::max(std::abs(*place), 0.01);
      *place += side == 0 ? -step : step;
      ASSERT_TRUE(simulation.Run(model, start, &outputs[side]));
    }
    const auto compare = [&](const std::vector<double>& low,
                             const std::vector<double>& high,
                             const SensitivityMatrix& sensitivity) {
      double size = 0.0, miss = 0.0;
      for (size_t i = 0; i < low.size(); ++i) {
        const double difference = (high[i] - low[i]) / (2.0 * step);
        size += difference * difference;
        const double error = difference - sensitivity(static_cast<Eigen::Index>(i), column);
        miss += error * error;
      }
      EXPECT_LE(std::sqrt(miss), 2e-3 * std::sqrt(size) + 1e-8) << "column " << column;
    };
    compare(outputs[0].velocity, outputs[1].velocity, at.velocity_sensitivity);
    compare(outputs[0].displacement, outputs[1].displacement, at.displacement_sensitivity);
  }
}

INSTANTIATE_TEST_SUITE_P(Catalogue,
                         EveryEffect,
                         testing::ValuesIn(EffectCatalogue().begin(), EffectCatalogue().end()),
                         [](const auto& info) { return std::string(info.param->info().name); });

TEST(EffectSimulation, AgreesWithTheSimulationOfTheBaseline) {
  const EffectInputs inputs = Inputs();
  OutputStamps stamps = Stamps();
  stamps.displacement = stamps.velocity;
  const EffectSimulation simulation(&inputs, stamps);
  const Simulation reference(inputs.command, stamps.velocity);
  std::vector<double> v(stamps.velocity.size()), x(v.size());
  ASSERT_TRUE(reference.Run(kSurge, {0.1, 2.0}, v, x));
  EffectOutputs outputs;
  ASSERT_TRUE(simulation.Run({kSurge, {}}, {0.1, 2.0}, &outputs));
  EXPECT_LT(Spread(outputs.velocity, v), 1e-7);
  EXPECT_LT(Spread(outputs.displacement, x), 1e-6);
}

// A linear vehicle under a step: v = f/d (1 - e^(-t/tau)), and with a thruster lag T in front
// v = f/d (1 - (tau e^(-t/tau) - T e^(-t/T)) / (tau - T)).
TEST(EffectSimulation, AnswersAStepThroughALagAsTheClosedFormDoes) {
  const double m = 500.0, d = 50.0, force = 30.0, T = 0.4, tau = m / d;
  EffectInputs inputs;
  inputs.command = {{0.0, 5.0}, {0.0, force}};
  OutputStamps stamps;
  for (int i = 0; i < 300; ++i) stamps.velocity.push_back(0.1 * i);
  const EffectSimulation simulation(&inputs, stamps);
  const ExtendedModel model = {{m, 0.0, d, 0.0}, {{FindEffect("thruster_lag"), {}, {T}}}};
  EffectOutputs outputs;
  ASSERT_TRUE(simulation.Run(model, {}, &outputs));
  for (size_t i = 0; i < stamps.velocity.size(); ++i) {
    const double t = stamps.velocity[i] - 5.0;
    const double expected =
        t <= 0.0
            ? 0.0
            : force / d * (1.0 - (tau * std::exp(-t / tau) - T * std::exp(-t / T)) / (tau - T));
    EXPECT_NEAR(outputs.velocity[i], expected, 1e-4) << "t = " << t;
  }
}

// What a sensor's first reading has too much dies away as exp(-(t - start) / T), whatever the
// vehicle does and however late its command comes, and no other sensor has any.
TEST(EffectSimulation, ForgetsWhereALaggingSensorStarted) {
  const double T = 1.3, excess = -0.2;
  const EffectInputs inputs = Inputs();
  const EffectSimulation simulation(&inputs, Stamps());
  const ActiveEffect lag = {FindEffect("sensor_lag"), {}, {T}};
  const ActiveEffect late = {FindEffect("time_offset"), {}, {0.23}};
  for (const ExtendedModel& model :
       {ExtendedModel{kSurge, {lag}}, ExtendedModel{kSurge, {late, lag}}}) {
    ASSERT_TRUE(EffectSimulation::HasReadingMemory(model));
    EffectOutputs settled, other;
    ASSERT_TRUE(simulation.Run(model, {0.1, 2.0}, &settled));
    ASSERT_TRUE(simulation.Run(model, {0.1, 2.0, excess}, &other));
    for (size_t i = 0; i < Stamps().velocity.size(); ++i) {
      const double t = Stamps().velocity[i] - Stamps().start;
      EXPECT_NEAR(other.velocity[i] - settled.velocity[i], excess * std::exp(-t / T), 1e-12) << t;
    }
    EXPECT_EQ(other.displacement, settled.displacement);
  }
  const ExtendedModel quick = {kSurge, {late}};
  EXPECT_FALSE(EffectSimulation::HasReadingMemory(quick));
  EffectOutputs settled, other;
  ASSERT_TRUE(simulation.Run(quick, {0.1, 2.0}, &settled));
  ASSERT_TRUE(simulation.Run(quick, {0.1, 2.0, excess}, &other));
  EXPECT_EQ(other.velocity, settled.velocity);
}

// What the water has too much in mind at the start, in linear drag: with the vehicle's speed v it
// is the state of d/dt (v, z) = A (v, z), and what it changes is the second column of exp(A t).
TEST(EffectSimulation, ForgetsWhatTheWaterRememberedAtTheStart) {
  const double m = 500.0, d = 50.0, k = 120.0, T = 3.0, excess = -0.2;
  const EffectInputs inputs = Inputs();
  const EffectSimulation simulation(&inputs, Stamps());
  const ActiveEffect memory = {FindEffect("fluid_memory"), {}, {k, T}};
  const ExtendedModel model = {{m, 0.0, d, 0.0}, {memory}};
  ASSERT_EQ(EffectSimulation::ExcessesOf(model), (std::vector{&InitialState::memory_excess}));
  EffectOutputs balanced, other;
  ASSERT_TRUE(simulation.Run(model, {0.1, 2.0}, &balanced));
  ASSERT_TRUE(simulation.Run(model, {0.1, 2.0, 0.0, excess}, &other));
  const double a = -(d + k) / m, b = k / m, c = 1.0 / T;
  const double mean = 0.5 * (a - c), root = std::sqrt(0.25 * (a + c) * (a + c) + b * c);
  double largest = 0.0;
  for (size_t i = 0; i < Stamps().velocity.size(); ++i) {
    const double t = Stamps().velocity[i] - Stamps().start;
    const double expected = excess * b * std::exp(mean * t) * std::sinh(root * t) / root;
    EXPECT_NEAR(other.velocity[i] - balanced.velocity[i], expected, 1e-5) << t;
    largest = std::max(largest, std::abs(expected));
  }
  EXPECT_GT(largest, 0.05);
  const ActiveEffect lag = {FindEffect("sensor_lag"), {}, {1.0}};
  EXPECT_EQ(EffectSimulation::ExcessesOf({kSurge, {memory, lag}}),
            (std::vector{&InitialState::reading_excess, &InitialState::memory_excess}));
  EXPECT_TRUE(EffectSimulation::ExcessesOf({kSurge, {}}).empty());
}

// From amid a log that was measured before, a run goes on as the one from the log's start does.
TEST(EffectSimulation, RemembersTheVelocityMeasuredBeforeItsStart) {
  EffectInputs inputs = Inputs();
  OutputStamps all;
  for (int i = 0; i < 1600; ++i) all.velocity.push_back(100.0 + 0.05 * i);
  all.start = all.velocity.front();
  const ExtendedModel model = {kSurge, {{FindEffect("fluid_memory"), {}, {150.0, 4.0}}}};
  EffectOutputs from_rest;
  ASSERT_TRUE(EffectSimulation(&inputs, all).Run(model, {}, &from_rest));
  const size_t middle = 850;  // speeding up
  OutputStamps rest;
  rest.velocity.assign(all.velocity.begin() + middle, all.velocity.end());
  rest.start = rest.velocity.front();
  const InitialState there = {from_rest.velocity[middle], 0.0};
  double miss[2] = {};
  for (const Dof measured : {Dof::kSurge, Dof::kHeave}) {
    for (SampledSignal& velocity : inputs.velocity) velocity = {};
    inputs.velocity[Index(measured)] = {all.velocity, from_rest.velocity};
    EffectOutputs amid;
    ASSERT_TRUE(EffectSimulation(&inputs, rest).Run(model, there, &amid));
    for (size_t i = 0; i < rest.velocity.size(); ++i) {
      miss[measured != Dof::kSurge] =
          std::max(miss[measured != Dof::kSurge],
                   std::abs(amid.velocity[i] - from_rest.velocity[middle + i]));
    }
  }
  EXPECT_LT(miss[0], 1e-5);
  EXPECT_GT(miss[1], 1e-3);  // in balance there, which it was not
}

// A linear spring k and mass m with damping d at rest x0 away from where the force balances.
// Under a constant force against quadratic damping: v = tanh(t / T), x = T log cosh(t / T).
TEST(EffectSimulation, ErrsByLessThanAThousandthInStepsOfTheMidpointRule) {
  constexpr double kTime = 890.0 / 60.0;  // [s]
  EffectInputs inputs;
  inputs.command = {{0.0}, {60.0}};
  OutputStamps stamps;
  for (int i = 0; i < 100; ++i) stamps.velocity.push_back(0.37 * i);
  stamps.displacement = stamps.velocity;
  const auto error = [&] {
    EffectOutputs outputs;
    EXPECT_TRUE(EffectSimulation(&inputs, stamps).Run({{890.0, 60.0, 0.0, 0.0}, {}}, {}, &outputs));
    double most = 0.0;
    for (std::size_t i = 0; i < stamps.velocity.size(); ++i) {
      const double t = stamps.velocity[i] / kTime;
      most = std::max(most, std::abs(outputs.velocity[i] - std::tanh(t)));
      most = std::max(most, std::abs(outputs.displacement[i] / kTime - std::log(std::cosh(t))));
    }
    return most;
  };
  const double classical = error();
  EXPECT_LT(classical, 1e-5);
  inputs.steps = {.longest = 0.5, .midpoint = 0.1};
  EXPECT_LT(error(), 1e-3);
  EXPECT_GT(error(), 3.0 * classical);  // they are other steps
}

TEST(EffectSimulation, SwingsOnASpringAsTheClosedFormDoes) {
  const double m = 500.0, d = 50.0, k = 20.0;
  EffectInputs inputs;
  inputs.command = {{0.0}, {0.0}};
  OutputStamps stamps;
  for (int i = 0; i < 500; ++i) stamps.displacement.push_back(0.2 * i);
  const EffectSimulation simulation(&inputs, stamps);
  const ExtendedModel model = {{m, 0.0, d, 0.0}, {{FindEffect("position_stiffness"), {}, {k}}}};
  EffectOutputs outputs;
  ASSERT_TRUE(simulation.Run(model, {0.0, 3.0}, &outputs));
  const double decay = d / (2.0 * m);
  const double frequency = std::sqrt(k / m - decay * decay);
  for (size_t i = 0; i < stamps.displacement.size(); ++i) {
    const double t = stamps.displacement[i];
    const double expected = 3.0 * std::exp(-decay * t) *
                            (std::cos(frequency * t) + decay / frequency * std::sin(frequency * t));
    EXPECT_NEAR(outputs.displacement[i], expected, 1e-5) << "t = " << t;
  }
}

// Undamped and let go at rest at the angle A, a righting moment K swings with the period
//
//   4 sqrt(J / K) F(sin(A / 2)),   F the complete elliptic integral of the first kind,
//
// which is 2 pi sqrt(J / K) at small angles.
TEST(EffectSimulation, SwingsInARightingMomentAsAPendulumDoes) {
  const double inertia = 0.35, moment = 1.4;
  for (const double angle : {0.01, 0.9, 2.0}) {
    const double period =
        4.0 * std::sqrt(inertia / moment) * std::comp_ellint_1(std::sin(0.5 * angle));
    EffectInputs inputs;
    inputs.command = {{0.0}, {0.0}};
    OutputStamps stamps;
    for (int i = 0; i <= 8; ++i) stamps.displacement.push_back(0.25 * i * period);
    const EffectSimulation simulation(&inputs, stamps);
    const ExtendedModel model = {{inertia, 0.0, 0.0, 0.0},
                                 {{FindEffect("righting_moment"), {.dof = Dof::kRoll}, {moment}}}};
    EffectOutputs outputs;
    ASSERT_TRUE(simulation.Run(model, {0.0, angle}, &outputs));
    for (int i = 0; i <= 8; ++i) {
      const double expected = i % 4 == 0 ? angle : i % 4 == 2 ? -angle : 0.0;
      // Two swings take some 80 steps of w h = 0.2, each late by (w h)^5 / 120 = 3e-6 of phase; at
      // large angles harmonics, which are later, take part.
      EXPECT_NEAR(outputs.displacement[i], expected, 1e-3 * angle) << angle << ", " << i;
    }
  }
  EXPECT_NEAR(4.0 * std::comp_ellint_1(std::sin(0.005)), 2.0 * std::numbers::pi, 1e-4);
}

TEST(EffectSimulation, TakesAnEffectFromOutsideTheLibrary) {
  const Effect effect = EffectOf<SquareRootDrag>();
  const EffectInputs inputs = Inputs();
  const EffectSimulation simulation(&inputs, Stamps());
  EffectOutputs low, high, at;
  ASSERT_TRUE(simulation.Run({kSurge, {{&effect, {}, {19.99}}}}, {}, &low));
  ASSERT_TRUE(simulation.Run({kSurge, {{&effect, {}, {20.01}}}}, {}, &high));
  ASSERT_TRUE(simulation.RunWithSensitivities({kSurge, {{&effect, {}, {20.0}}}}, {}, &at));
  for (size_t i = 0; i < low.velocity.size(); i += 50) {
    const double difference = (high.velocity[i] - low.velocity[i]) / 0.02;
    EXPECT_NEAR(at.velocity_sensitivity(static_cast<Eigen::Index>(i), 6), difference, 1e-7);
  }
}

}  // namespace
}  // namespace fathom
