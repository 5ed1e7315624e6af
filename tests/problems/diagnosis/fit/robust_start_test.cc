// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/fit/started_model.h"

#include <vector>

#include "surge_run.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

MeasuredSegments SegmentsFrom(const SurgeRun& run, std::uint64_t seed) {
  const std::vector<Log> logs = {LogOf(run, seed)};
  return MeasuredSegmentsOf(logs, Dof::kSurge);
}

void ExpectTruth(const StartedModel& start, double share) {
  const UncoupledModel<double>& model = start.model.baseline;
  EXPECT_NEAR(model.inertia, kSurgeTruth.inertia, share * kSurgeTruth.inertia);
  EXPECT_NEAR(model.quadratic_damping, kSurgeTruth.quadratic_damping, share * 60.0);
  EXPECT_NEAR(model.linear_damping, kSurgeTruth.linear_damping, share * 39.0);
}

// Without noise nothing but the integrators' steps is between fit and truth.
TEST(RobustStart, FindsTheTruthInPerfectVelocities) {
  SurgeRun run;
  run.input = Multisine(40.0);
  run.velocity_noise = 1e-7;
  const auto start = FindRobustStart(SegmentsFrom(run, 1).all);
  ASSERT_TRUE(start);
  ExpectTruth(*start, 1e-3);
  EXPECT_NEAR(start->initial[0].velocity, 0.0, 1e-4);
}

TEST(RobustStart, FindsTheTruthInPerfectPoses) {
  SurgeRun run;
  run.input = Multisine(40.0);
  run.has_velocity = false;
  run.has_poses = true;
  run.position_noise = 1e-6;
  const auto start = FindRobustStart(SegmentsFrom(run, 1).all);
  ASSERT_TRUE(start);
  ExpectTruth(*start, 1e-3);
}

// A wild value every fiftieth sample, of 30 times the noise, all the same way.
TEST(RobustStart, IsNotMovedByOutliers) {
  SurgeRun run;
  run.input = Multisine(40.0);
  MeasuredSegments segments = SegmentsFrom(run, 1);
  const auto clean = FindRobustStart(segments.all);
  for (size_t i = 0; i < segments.all[0].velocity.size(); i += 50) {
    segments.all[0].velocity[i] += 0.3;
  }
  const auto start = FindRobustStart(segments.all);
  ASSERT_TRUE(clean && start);
  // A fiftieth of the samples pulls with no more than Huber's limit of about 1.3 standard
  // deviations: a constant of 0.03 standard deviations, 0.3 mm/s of speeds of 0.3 m/s.
  EXPECT_NEAR(start->model.baseline.inertia, clean->model.baseline.inertia, 0.01 * 890.0);
}

TEST(RobustStart, IsPhysicalWhereAnEffectWantsNegativeDamping) {
  SurgeRun run;
  run.input = Multisine(40.0);
  run.effects = "thruster_lag:time_constant=1.0";
  const auto start = FindRobustStart(SegmentsFrom(run, 1).all);
  ASSERT_TRUE(start);
  EXPECT_GT(start->model.baseline.inertia, 0.0);
  EXPECT_GE(start->model.baseline.quadratic_damping, 0.0);
  EXPECT_GE(start->model.baseline.linear_damping, 0.0);
}

}  // namespace
}  // namespace fathom
