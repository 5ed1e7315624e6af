// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <limits>

#include "camera_experiment.h"

namespace fathom {

// What each family makes of the corners of one experiment, against the truth.
struct JointTrial {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  bool is_usable = false;  // by all of them
  // Relative error of the inertia; by least squares and output error from the PnP poses.
  // `published_least_squares` compares the poses' Savitzky-Golay derivatives with the command as it
  // is at the stamps; Fathom's own sends both through one filter (docs/signal.md (3)).
  double published_least_squares = kNone, least_squares = kNone;
  double output_error = kNone, joint = kNone;
  // Of the joint model's parameters: error over its reported standard deviation, and over the
  // Cramer-Rao bound. The latter is known where the wander is one that the bound is made for.
  std::array<double, 4> over_std = {kNone, kNone, kNone, kNone};
  std::array<double, 4> over_bound = {kNone, kNone, kNone, kNone};
  // Of the free run against the true velocity: the joint model's, and that of output error on a
  // velocity sensor of 1 cm/s.
  double nmae = kNone, sensor_nmae = kNone;
  // RMS error of the refined poses over that of the PnP poses.
  double position = kNone, attitude = kNone;
  double seconds = kNone;  // of the joint refinement
};

JointTrial RunJointTrial(const CameraExperiment& experiment);

}  // namespace fathom
