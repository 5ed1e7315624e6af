// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/effect_simulation.h"
#include "fathom/vehicle/effects/catalogue.h"

#include <cmath>

#include <gtest/gtest.h>

namespace fathom {
namespace {

// A motor's shaft: friction as EFFECTS.md has it is so stiff that the classical scheme would need
// 200 000 steps a second. Sharp friction has a closed form, and differs from it by 0.005 rad/s.
TEST(DryFriction, ComesToRestAsTheClosedFormDoes) {
  constexpr double kInertia = 1.2e-4, kFriction = 0.03, kTorque = 0.05;
  EffectInputs inputs;
  inputs.dof = Dof::kYaw;
  for (int i = 0; i < 400; ++i) {
    inputs.command.time.push_back(0.01 * i);
    const double t = 0.01 * i;
    inputs.command.value.push_back(t < 1.0 - 1e-9 ? kTorque : t < 3.0 - 1e-9 ? 0.015 : -kTorque);
  }
  OutputStamps stamps;
  for (int i = 0; i < 390; ++i) stamps.velocity.push_back(0.003 + 0.01 * i);
  const ExtendedModel model = {{kInertia, 0.0, 0.0, 0.0},
                               {{FindEffect("coulomb_friction"), {Dof::kYaw}, {kFriction}}}};
  EffectOutputs outputs;
  ASSERT_TRUE(EffectSimulation(&inputs, stamps).Run(model, {0.0, 0.0}, &outputs));
  const double top = (kTorque - kFriction) / kInertia;  // at 1 s: 167 rad/s
  const double stop = 1.0 + top * kInertia / (kFriction - 0.015);
  for (std::size_t i = 0; i < stamps.velocity.size(); ++i) {
    const double t = stamps.velocity[i];
    const double expected = t < 1.0    ? top * t
                            : t < stop ? top - (t - 1.0) * (kFriction - 0.015) / kInertia
                            : t < 3.0  ? 0.0
                                       : -(t - 3.0) * (kTorque - kFriction) / kInertia;
    EXPECT_NEAR(outputs.velocity[i], expected, 5e-4 * top) << t;
  }
}

TEST(DryFriction, HasTheDerivativesOfItsFiniteDifferences) {
  EffectInputs inputs;
  for (int i = 0; i < 3000; ++i) {
    inputs.command.time.push_back(0.01 * i);
    inputs.command.value.push_back(40.0 * std::sin(0.5 * 0.01 * i));
  }
  OutputStamps stamps;
  for (int i = 1; i < 290; ++i) stamps.velocity.push_back(0.1 * i);
  ExtendedModel model = {{20.0, 30.0, 10.0, 1.0},
                         {{FindEffect("coulomb_friction"), {Dof::kSurge}, {15.0}}}};
  const EffectSimulation simulation(&inputs, stamps);
  EffectOutputs outputs, higher, lower;
  ASSERT_TRUE(simulation.RunWithSensitivities(model, {0.1, 0.0}, &outputs));
  constexpr double kStep = 1e-4;
  model.effects[0].values[0] += kStep;
  ASSERT_TRUE(simulation.Run(model, {0.1, 0.0}, &higher));
  model.effects[0].values[0] -= 2.0 * kStep;
  ASSERT_TRUE(simulation.Run(model, {0.1, 0.0}, &lower));
  double difference = 0.0, size = 0.0;
  for (std::size_t i = 0; i < stamps.velocity.size(); ++i) {
    const double slope = (higher.velocity[i] - lower.velocity[i]) / (2.0 * kStep);
    const double exact = outputs.velocity_sensitivity(static_cast<Eigen::Index>(i),
                                                      EffectSimulation::kFirstEffectColumn);
    difference += (slope - exact) * (slope - exact);
    size += exact * exact;
  }
  EXPECT_LT(std::sqrt(difference / size), 0.03);
}

}  // namespace
}  // namespace fathom
