// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/problem/joint_problem.h"

#include <cmath>
#include <cstddef>

#include "camera_experiment.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

// Without the model nothing ties the frames together: each gets the pose that fits its own corners
// best, as the experiment's own Gauss-Newton found it.
TEST(JointProblem, WithoutTheModelIsABundleAdjustment) {
  const SyntheticCameraRun run = Synthesize({.dof = Dof::kYaw, .num_markers = 4, .duration = 3.0});
  const CameraSegment& camera = run.input.segments[0];
  JointData data;
  data.setup = {run.input.camera, run.input.body_from_camera};
  data.excited = Index(Dof::kYaw);
  data.segments.push_back(
      {camera.detections,
       run.input.map,
       PredictedMotion(camera.command, camera.time, data.excited, MotionScales())});
  JointUnknowns unknowns;
  unknowns.model = {std::log(300.0), 200.0, 30.0, 0.0};
  unknowns.segments.resize(1);
  ASSERT_TRUE(data.segments[0].motion.Update(unknowns.Motion(0)));
  SegmentUnknowns& own = unknowns.segments[0];
  own.deviation.resize(camera.time.size());
  own.rate.resize(camera.time.size());
  for (size_t k = 0; k < camera.time.size(); ++k) {
    PoseVector moved = VectorFromPose(camera.world_from_body[k]) - data.segments[0].motion.Mean(k);
    moved += PoseVector(0.03, -0.02, 0.02, 0.01, -0.01, 0.02);
    PoseVector::Map(own.deviation[k].data()) = moved;
  }
  ProcessSet processes;
  processes.corner_sigma = 0.3;
  GlobalsPrior prior;  // clock, size and mount are known
  for (int i = kSizeColumn; i < kNumShared; ++i) prior.std[i] = 0.0;
  prior.std[kClockColumn] = 0.0;
  const BoundedSolve solve =
      SolveJoint(&data, processes, {prior}, {.without_model = true}, &unknowns);
  ASSERT_TRUE(solve.converged) << solve.message;
  for (size_t k = 0; k < camera.time.size(); ++k) {
    const PoseVector found = PoseAt(data.segments[0], own, k);
    const PoseVector alone = VectorFromPose(camera.world_from_body[k]);
    // Ceres stops where the cost, some 400, would fall by less than 1e-8 of itself: at three
    // thousandths of a pose's standard deviation, which is below a centimetre.
    EXPECT_LT((found - alone).norm(), 3e-5) << k;
  }
}

}  // namespace
}  // namespace fathom
