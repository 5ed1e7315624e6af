// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/fit/momentum_balance.h"

#include "fathom/diagnosis/data/measured_segments.h"
#include "fathom/vehicle/effects/catalogue.h"

#include <span>
#include <string>

#include "surge_run.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

MeasuredSegments SegmentsOf(SurgeRun run, int seed) {
  const Log log = LogOf(run, seed);
  return MeasuredSegmentsOf(std::span<const Log>(&log, 1), Dof::kSurge);
}

SurgeRun QuietRun(const std::string& effects) {
  SurgeRun run;
  run.input = Multisine(60.0);
  run.velocity_noise = 1e-4;
  run.effects = effects;
  return run;
}

TEST(MomentumBalance, FindsTheModelThatMovedTheVehicle) {
  const MeasuredSegments segments = SegmentsOf(QuietRun(""), 3);
  const auto fit = MomentumBalance(segments.all).Fit();
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->model.baseline.inertia, kSurgeTruth.inertia, 0.03 * kSurgeTruth.inertia);
}

// A spring that carries most of the motion: no baseline comes near it.
TEST(MomentumBalance, FindsASpringThatNoBaselineComesNear) {
  const MeasuredSegments segments = SegmentsOf(QuietRun("position_stiffness:stiffness=400"), 3);
  const auto fit =
      MomentumBalance(segments.all).FitWith({FindEffect("position_stiffness"), {}, {1.0}});
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->model.baseline.inertia, kSurgeTruth.inertia, 0.05 * kSurgeTruth.inertia);
  EXPECT_NEAR(fit->model.effects[0].values[0], 400.0, 20.0);
}

// From poses alone the velocity is their derivative.
TEST(MomentumBalance, FindsASpringFromPosesAlone) {
  SurgeRun run = QuietRun("position_stiffness:stiffness=400");
  run.has_velocity = false;
  run.has_poses = true;
  run.position_noise = 1e-4;
  const MeasuredSegments segments = SegmentsOf(run, 3);
  const auto fit =
      MomentumBalance(segments.all).FitWith({FindEffect("position_stiffness"), {}, {1.0}});
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->model.effects[0].values[0], 400.0, 40.0);
}

// Friction holds the vehicle for part of the run, where it is whatever the command is.
TEST(MomentumBalance, FindsFrictionBetweenTheStops) {
  const MeasuredSegments segments = SegmentsOf(QuietRun("coulomb_friction:force=20"), 3);
  const auto fit =
      MomentumBalance(segments.all).FitWith({FindEffect("coulomb_friction"), {}, {1.0}});
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->model.effects[0].values[0], 20.0, 3.0);
}

TEST(MomentumBalance, KnowsWhichEffectsAreForcesThatTheMotionTells) {
  for (const char* name : {"thrust_dead_zone",
                           "thruster_lag",
                           "time_offset",
                           "cubic_damping",
                           "position_stiffness",
                           "coriolis_coupling"}) {
    EXPECT_TRUE(MomentumBalance::HasForce(*FindEffect(name))) << name;
  }
  for (const char* name : {"fluid_memory", "steady_current", "sensor_bias", "pose_scale"}) {
    EXPECT_FALSE(MomentumBalance::HasForce(*FindEffect(name))) << name;
  }
}

}  // namespace
}  // namespace fathom
