// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Whatever way the vehicle heads and the world lies.

#include "fathom/joint_refinement/joint_refinement.h"

#include <cmath>

#include "camera_experiment.h"
#include "expect_found.h"
#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace fathom {
namespace {

// The same run in another world: everything seen from a frame of this attitude.
SyntheticCameraRun InTurnedWorld(SyntheticCameraRun run, const Eigen::Quaterniond& world_from_new) {
  const Pose new_from_world = {world_from_new.conjugate(), Eigen::Vector3d::Zero()};
  for (Marker& marker : run.input.map.markers) {
    marker.world_from_tag = new_from_world * marker.world_from_tag;
  }
  for (Pose& pose : run.input.segments[0].world_from_body) pose = new_from_world * pose;
  for (Pose& pose : run.true_world_from_body) pose = new_from_world * pose;
  return run;
}

// What the world's axes are called must not matter: a wall that is not at right angles to them, or
// a tag's own frame as the world, in which the vehicle's pitch is 90 degrees.
TEST(JointRefinement, DoesNotDependOnTheWorldsAxes) {
  for (const Dof dof : {Dof::kSurge, Dof::kHeave, Dof::kYaw}) {
    SCOPED_TRACE(Name(dof));
    const SyntheticCameraRun run =
        Synthesize({.dof = dof, .input = InputKind::kMultisine, .duration = 40.0});
    const JointSummary straight = FitJoint(run.input);
    ASSERT_TRUE(straight.IsUsable()) << straight.message;
    for (const Eigen::Quaterniond& turn :
         {Eigen::Quaterniond(Eigen::AngleAxisd(0.3, Eigen::Vector3d(0.2, 0.3, 1.0).normalized())),
          Eigen::Quaterniond(Eigen::AngleAxisd(2.0, Eigen::Vector3d::UnitZ())),
          run.input.map.markers[0].world_from_tag.rotation}) {
      const SyntheticCameraRun turned = InTurnedWorld(run, turn);
      const JointSummary summary = FitJoint(turned.input);
      ASSERT_TRUE(summary.IsUsable()) << summary.message;
      const ParameterVector found = ToVector(summary.model), expected = ToVector(straight.model);
      for (int i = 0; i < kNumParameters; ++i) {
        const double std = std::sqrt(straight.covariance(i, i));
        EXPECT_NEAR(found[i], expected[i], 0.2 * std) << kParameterInfo[i].name;
        EXPECT_NEAR(std::sqrt(summary.covariance(i, i)), std, 0.05 * std);
      }
      EXPECT_NEAR(PathError(summary.segments[0].world_from_body, turned),
                  PathError(straight.segments[0].world_from_body, run),
                  0.05 * PathError(straight.segments[0].world_from_body, run));
      const Eigen::Matrix3d R = turn.toRotationMatrix();
      const Eigen::Matrix3d in_new = summary.segments[0].pose_covariance[7].topLeftCorner<3, 3>();
      const Eigen::Matrix3d in_old = straight.segments[0].pose_covariance[7].topLeftCorner<3, 3>();
      EXPECT_LT((R * in_new * R.transpose() - in_old).norm(), 0.05 * in_old.norm());
    }
  }
}

// Two runs towards walls that face each other: one model.
TEST(JointRefinement, JoinsRunsOfOppositeHeadings) {
  SyntheticCameraRun run = Synthesize({.duration = 40.0});
  const JointSummary alone = FitJoint(run.input);
  SyntheticCameraRun back =
      InTurnedWorld(Synthesize({.input = InputKind::kMultisine, .duration = 40.0, .seed = 2}),
                    Eigen::Quaterniond(Eigen::AngleAxisd(M_PI - 0.2, Eigen::Vector3d::UnitZ())));
  for (Marker marker : back.input.map.markers) {
    marker.id += 100;
    run.input.map.markers.push_back(marker);
  }
  for (auto& detections : back.input.segments[0].detections) {
    for (Detection& detection : detections) detection.tag_id += 100;
  }
  run.input.segments.push_back(back.input.segments[0]);
  const JointSummary together = FitJoint(run.input);
  ExpectFound(together, run, 0.005);
  EXPECT_LT(together.covariance(kInertia, kInertia), alone.covariance(kInertia, kInertia));
  EXPECT_LT(PathError(together.segments[1].world_from_body, back),
            0.6 * PathError(back.input.segments[0].world_from_body, back));
}

// A camera that is mounted turned by 0.1 rad from what mount.yaml says makes the motion look
// shorter by the cosine, half a percent, along an axis that it does not follow: that is said.
TEST(JointRefinement, SaysThatTheMotionDoesNotFollowTheAxis) {
  SyntheticCameraRun run = Synthesize({.input = InputKind::kMultisine, .duration = 120.0});
  EXPECT_TRUE(FitJoint(run.input).caveats.empty());
  const Pose body_from_turned = {
      Eigen::Quaterniond(Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitZ())),
      Eigen::Vector3d::Zero()};
  run.input.body_from_camera = body_from_turned * run.input.body_from_camera;
  for (Pose& pose : run.input.segments[0].world_from_body) pose = pose * body_from_turned.Inverse();
  const JointSummary summary = FitJoint(run.input);
  ASSERT_TRUE(summary.IsUsable()) << summary.message;
  const double std = std::sqrt(summary.covariance(kInertia, kInertia));
  EXPECT_NEAR(summary.model.inertia, run.truth.inertia / std::cos(0.1), 4.0 * std);
  EXPECT_GT(summary.model.inertia, run.truth.inertia + 4.0 * std);
  ASSERT_EQ(summary.caveats.size(), 1u);
  EXPECT_TRUE(summary.caveats[0].starts_with("The vehicle moves 5.")) << summary.caveats[0];
}

}  // namespace
}  // namespace fathom
