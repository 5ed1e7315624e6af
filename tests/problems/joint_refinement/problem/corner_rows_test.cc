// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/problem/corner_rows.h"

#include "camera_experiment.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(CornerRows, AgreeWithDifferences) {
  const SyntheticCameraRun run = Synthesize({.num_markers = 4, .duration = 2.0});
  const CameraSetup setup = {run.input.camera, run.input.body_from_camera};
  const Detection& detection = run.input.segments[0].detections[3][2];
  PoseVector eta;
  eta << 0.1, -0.2, 0.15, 0.05, -0.07, 0.1;
  const SetupUnknowns unknowns = {1.02, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0}};
  const auto at = [&](const PoseVector& pose, const SetupUnknowns& u) {
    CornerRows rows;
    EXPECT_TRUE(EvaluateCorners(
        setup, u, *run.input.map.Find(detection.tag_id), detection, pose, 0.5, true, &rows));
    return rows;
  };
  const CornerRows rows = at(eta, unknowns);
  constexpr double kMove = 1e-6;
  for (int i = 0; i < 6; ++i) {
    PoseVector up = eta, down = eta;
    up[i] += kMove;
    down[i] -= kMove;
    const Eigen::Matrix<double, 8, 1> slope =
        (at(up, unknowns).residual - at(down, unknowns).residual) / (2.0 * kMove);
    EXPECT_LT((slope - rows.by_pose.col(i)).norm(), 1e-6 * (1.0 + slope.norm())) << i;
  }
  for (int i = 0; i < 7; ++i) {
    SetupUnknowns up = unknowns, down = unknowns;
    (i == 0 ? up.size_scale : up.mount[i - 1]) += kMove;
    (i == 0 ? down.size_scale : down.mount[i - 1]) -= kMove;
    const Eigen::Matrix<double, 8, 1> slope =
        (at(eta, up).residual - at(eta, down).residual) / (2.0 * kMove);
    EXPECT_LT((slope - rows.by_setup.col(i)).norm(), 1e-6 * (1.0 + slope.norm())) << i;
  }
}

}  // namespace
}  // namespace fathom
