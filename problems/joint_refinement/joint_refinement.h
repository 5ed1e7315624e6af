// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/joint_refinement/process_set.h"
#include "fathom/log/held_command.h"
#include "fathom/simulate/simulate.h"
#include "fathom/vehicle/parameters.h"
#include "fathom/vision/camera_model.h"
#include "fathom/vision/detection.h"
#include "fathom/vision/marker_map.h"
#include "fathom/vision/pose.h"

#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// One unbroken stretch of a log as the camera saw it: the frames in which it saw a marker.
struct CameraRun {
  std::vector<double> time;                        // of the frames [s], strictly increasing
  std::vector<std::vector<Detection>> detections;  // of each frame, at least one
  std::vector<Pose> world_from_body;               // of each frame, a first guess by PnP
  HeldCommand command;                             // of the excited DOF
};

// One or several logs of one vehicle moving along one DOF.
struct JointInput {
  Dof dof = Dof::kSurge;
  CameraModel camera;
  MarkerMap map;
  Pose body_from_camera;
  std::vector<CameraRun> runs;
};

struct JointOptions {
  // Where the search starts. Absent: output error on the displacement of the first guesses.
  std::optional<UncoupledModel<double>> initial_guess = {};

  // True: no model. The excited DOF moves as the corners say, and nobody reads the command; of the
  // summary only the poses and the processes then mean something. docs/joint_refinement.md,
  // "Without a model"
  bool moves_freely = false;

  // Standard deviations of what is known beforehand; 0: not estimated. Infinite: nothing is known.
  double clock_offset_std = 0.0;    // of each run [s]
  double size_scale_std = 0.0;      // of the markers' sides, no unit
  double mount_position_std = 0.0;  // of the camera in the body [m]
  double mount_angle_std = 0.0;     // [rad]

  // Squared norm of a detection's eight whitened residuals from which on it counts by its
  // logarithm. Above 0. 26.1 is passed by one good detection in a thousand.
  double loss_limit = 26.1;

  // Above 0.
  int max_iterations = 50;

  // How often the processes are estimated about the refined trajectory, at most. At least 1.
  int max_rounds = 6;

  // Called before each round with its number from 1 on; may be empty.
  std::function<void(int round, int max_rounds)> on_round = {};

  // One line for each rule that is broken; empty if these options can be used.
  std::vector<std::string> Problems() const;
};

// A run as refined.
struct RefinedRun {
  InitialState start;
  std::array<std::array<double, 4>, 5> response = {};  // see PredictedMotion
  double clock_offset = 0.0;                           // [s], with its standard deviation
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
  int num_iterations = -1;  // of Ceres, over all rounds
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
  std::vector<RefinedRun> runs;
  int num_detections = 0;

  // What the reader must know beyond the intervals, a sentence each.
  std::vector<std::string> caveats;
};

// The model, every camera pose, and what else is asked for, from the corners themselves:
// docs/joint_refinement.md. Throws InputError if the options or the input cannot be used. A poor
// fit does not throw: see the summary.
JointSummary FitJoint(const JointInput& input, const JointOptions& options = {});

}  // namespace fathom
