// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/mean_thruster_forces.h"

#include "fathom/vehicle/effects/catalogue.h"

#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;

ExtendedModel With(const char* effect, std::vector<double> values) {
  return {{40.0, 15.0, 20.0, 0.0}, {{FindEffect(effect), {}, std::move(values)}}};
}

// 10 N from 1 s on, -4 N from 2.5 s on.
EffectInputs Steps() {
  EffectInputs inputs;
  inputs.command = {{0.0, 1.0, 2.5}, {0.0, 10.0, -4.0}};
  return inputs;
}

TEST(MeanThrusterForces, AreTheMeansOfAHeldCommand) {
  const std::vector<double> times = {0.5, 1.5, 2.0, 3.0, 4.0};
  EXPECT_THAT(MeanThrusterForces(Steps(), {{40.0, 15.0, 20.0, 0.0}, {}}, times),
              ElementsAre(5.0, 10.0, 3.0, -4.0));
}

TEST(MeanThrusterForces, ComeLateByADelay) {
  const std::vector<double> times = {0.5, 1.5, 2.0, 3.0};
  EXPECT_THAT(MeanThrusterForces(Steps(), With("time_offset", {0.25}), times),
              ElementsAre(DoubleNear(2.5, 1e-12), DoubleNear(10.0, 1e-12), DoubleNear(6.5, 1e-12)));
}

// From rest, the force under a step of 10 N is 10 (1 - exp(-t / T)).
TEST(MeanThrusterForces, FollowWithALag) {
  const double lag = 0.4;
  const auto impulse = [&](double t) { return 10.0 * (t - lag * (1.0 - std::exp(-t / lag))); };
  const std::vector<double> times = {0.0, 1.0, 1.3, 2.0, 2.4};
  EXPECT_THAT(MeanThrusterForces(Steps(), With("thruster_lag", {lag}), times),
              ElementsAre(DoubleNear(0.0, 1e-12),
                          DoubleNear(impulse(0.3) / 0.3, 1e-12),
                          DoubleNear((impulse(1.0) - impulse(0.3)) / 0.7, 1e-12),
                          DoubleNear((impulse(1.4) - impulse(1.0)) / 0.4, 1e-12)));
}

// A thruster that was already running when the times begin has long reached its force.
TEST(MeanThrusterForces, RememberTheCommandBefore) {
  EffectInputs inputs;
  inputs.command = {{0.0, 20.0}, {10.0, 10.0}};
  const std::vector<double> times = {19.0, 19.5};
  EXPECT_THAT(MeanThrusterForces(inputs, With("thruster_lag", {0.4}), times),
              ElementsAre(DoubleNear(10.0, 1e-9)));
}

TEST(MeanThrusterForces, OfFewerThanTwoTimesAreNone) {
  EXPECT_TRUE(MeanThrusterForces(Steps(), {{40.0, 15.0, 20.0, 0.0}, {}}, {}).empty());
}

}  // namespace
}  // namespace fathom
