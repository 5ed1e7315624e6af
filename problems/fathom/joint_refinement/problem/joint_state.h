// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/joint_refinement/motion/linear_segment.h"
#include "fathom/joint_refinement/motion/predicted_motion.h"
#include "fathom/joint_refinement/problem/corner_rows.h"
#include "fathom/joint_refinement/processes/process_set.h"

#include <array>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// One unbroken stretch of detections, as the search sees it.
struct JointSegment {
  std::vector<std::vector<Detection>> detections;  // of each frame
  MarkerMap map;                                   // in the segment's frame
  PredictedMotion motion;
};

// What is fixed during a search.
struct JointData {
  CameraSetup setup;
  int excited = 0;  // coordinate of eta
  std::vector<JointSegment> segments;
  double loss_limit = 26.1;  // of a detection's eight squared, whitened residuals
};

// The unknowns of one segment. The pose of frame k is Mean(k) + deviation[k]: one to one with the
// pose itself, and a coordinate that does nothing of its own needs no unknowns.
struct SegmentUnknowns {
  std::array<double, 2> start = {};
  std::array<double, kNumResponse> response = {};
  double clock_offset = 0.0;
  std::vector<std::array<double, 6>> deviation;  // by coordinate
  std::vector<std::array<double, 6>> rate;       // d deviation / dt
};

// All unknowns of the joint problem.
struct JointUnknowns {
  std::array<double, kModelColumns> model = {};  // [0]: log inertia
  SetupUnknowns setup;
  std::vector<SegmentUnknowns> segments;

  MotionUnknowns Motion(size_t segment) const {
    return {
        model, segments[segment].start, segments[segment].response, segments[segment].clock_offset};
  }
};

// Pose of a frame; the segment's motion must be up to date.
PoseVector PoseAt(const JointSegment& segment, const SegmentUnknowns& unknowns, size_t frame);

// The corners linearised about `unknowns`; weighted by the loss at `corner_sigma` [px]. False if a
// simulation diverges or a corner falls behind the camera.
bool Linearise(JointData* data,
               const JointUnknowns& unknowns,
               double corner_sigma,
               std::vector<LinearSegment>* segments);

// Moves `unknowns` by the changes of the globals and sets the deviations.
void Step(const std::vector<Eigen::VectorXd>& change,
          const std::vector<std::vector<Eigen::Matrix<double, 12, 1>>>& deviations,
          JointUnknowns* unknowns);

}  // namespace fathom
