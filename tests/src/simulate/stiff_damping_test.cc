// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/effect_simulation.h"

#include <cmath>

#include <gtest/gtest.h>

namespace fathom {
namespace {

// m v' = tau - d v |v| under a held tau > 0 from a speed `v0` of the same sign.
double SpeedAfter(double v0, double tau, double inertia, double damping, double t) {
  const double steady = std::sqrt(tau / damping);
  const double tanh = std::tanh(damping * steady * t / inertia);
  return steady * (v0 + steady * tanh) / (steady + v0 * tanh);
}

// A search tries vehicles with a time constant of 20 ms, of which the classical scheme would take
// 40 steps for each command.
TEST(StiffDamping, FollowsTheClosedFormInFewSteps) {
  constexpr double kInertia = 10.0, kDamping = 50.0, kHeld = 0.2;
  EffectInputs inputs;
  OutputStamps stamps;
  for (int i = 0; i < 100; ++i) {
    inputs.command.time.push_back(kHeld * i);
    inputs.command.value.push_back(1250.0 * (0.55 + 0.45 * std::sin(0.9 * i)));
    for (const double share : {0.1, 0.5, 1.0}) stamps.velocity.push_back(kHeld * (i + share));
  }
  const ExtendedModel model = {{kInertia, kDamping, 0.0, 0.0}, {}};
  EffectOutputs outputs;
  ASSERT_TRUE(EffectSimulation(&inputs, stamps).Run(model, {3.0, 0.0}, &outputs));
  double begin = 3.0, sum = 0.0;
  for (std::size_t row = 0; row < stamps.velocity.size(); ++row) {
    const std::size_t i = row / 3;
    const double since = stamps.velocity[row] - inputs.command.time[i];
    const double expected = SpeedAfter(begin, inputs.command.value[i], kInertia, kDamping, since);
    EXPECT_NEAR(outputs.velocity[row], expected, 0.15) << stamps.velocity[row];
    sum += (outputs.velocity[row] - expected) * (outputs.velocity[row] - expected);
    if (row % 3 == 2) begin = expected;
  }
  EXPECT_LT(std::sqrt(sum / static_cast<double>(stamps.velocity.size())), 0.03);  // of 5 m/s
  EXPECT_LT(outputs.num_steps, 1000);
}

TEST(StiffDamping, IsGivenUpWhereItIsOfNoVehicle) {
  EffectInputs inputs;
  inputs.command = {{0.0, 1.0}, {0.0, 100.0}};
  EffectOutputs outputs;
  const EffectSimulation simulation(&inputs, {0.0, {0.5, 1.5, 2.5}, {}});
  EXPECT_FALSE(simulation.Run({{1.0, 0.0, 200.0, 0.0}, {}}, {}, &outputs));
  EXPECT_TRUE(simulation.Run({{1.0, 0.0, 50.0, 0.0}, {}}, {}, &outputs));
  EXPECT_NEAR(outputs.velocity[2], 2.0, 1e-9);
}

}  // namespace
}  // namespace fathom
