// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/geometry/pose.h"
#include "fathom/joint_refinement/motion/global_columns.h"
#include "fathom/joint_refinement/processes/process_set.h"
#include "fathom/simulate/simulate.h"
#include "fathom/vehicle/parameters.h"
#include "fathom/vehicle/uncoupled_model.h"

#include <array>
#include <limits>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// A segment as refined.
struct RefinedSegment {
  InitialState start;
  std::array<std::array<double, kResponseTerms>, kNumHeld> response = {};  // see PredictedMotion
  double clock_offset = 0.0;  // [s], with its standard deviation
  double clock_offset_std = 0.0;
  std::vector<Pose> world_from_body;  // of each frame

  // Of each frame's (translation, rotation vector about the body's axes), [m] and [rad], as in
  // StampedPose; everything else unknown as well.
  std::vector<Eigen::Matrix<double, 6, 6>> pose_covariance;
  std::vector<double> displacement;  // of the excited DOF by the model [m] or [rad]
  std::vector<double> velocity;      // of the excited DOF by the model [m/s] or [rad/s]
  int num_outliers = 0;              // detections that the loss does not take in full
};

// Numbers that were not computed are NaN, never zero.
struct JointSummary {
  static constexpr double kNotComputed = std::numeric_limits<double>::quiet_NaN();

  // True if the search converged to a physical model that the data determine.
  bool IsUsable() const { return converged && determined; }

  std::string message = "FitJoint() was not called.";
  bool converged = false;
  bool determined = false;
  bool settled = false;        // the estimate of the processes; see the caveats where it did not
  bool reached_setup = false;  // the search came to where size and mount move if they are free
  int num_iterations = -1;     // of Ceres, over all rounds
  int num_rounds = -1;
  double initial_cost = kNotComputed;
  double final_cost = kNotComputed;
  double seconds_per_iteration = kNotComputed;  // of the last round

  UncoupledModel<double> model = {kNotComputed, kNotComputed, kNotComputed, kNotComputed};

  // In the order of kParameterInfo. A damping that ended on its bound 0 has the spread it would
  // have without the bound; its interval is to be cut at 0.
  ParameterCovariance covariance = ParameterCovariance::Constant(kNotComputed);
  std::array<bool, kNumParameters> on_bound = {};

  double size_scale = 1.0;
  double size_scale_std = 0.0;
  std::array<double, 6> mount = {};  // small move of body_from_camera: docs/joint_refinement.md
  std::array<double, 6> mount_std = {};

  ProcessSet processes;
  std::vector<RefinedSegment> segments;
  int num_detections = 0;

  // What the reader must know beyond the intervals, a sentence each.
  std::vector<std::string> caveats;
};

}  // namespace fathom
