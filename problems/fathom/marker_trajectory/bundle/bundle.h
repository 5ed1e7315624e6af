// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/marker_map.h"
#include "fathom/geometry/pose.h"
#include "fathom/geometry/pose_increment.h"

#include <limits>
#include <string>
#include <vector>

namespace fathom {

// One frame of a bundle adjustment: where its camera is thought to be, and what it saw.
struct AdjustedFrame {
  Pose world_from_camera;       // a start
  std::vector<int> detections;  // indices among all; one at least
  double noise_scale = 1.0;     // of its corners: their sigma is so many times that of the options
};

struct BundleAdjustmentOptions {
  // Standard deviation of a corner's u and v [px], above 0: what residuals are divided by, times
  // the noise scale of the frame.
  double corner_sigma = 1.0;

  // A corner further off than so many corner sigmas counts linearly; infinity: never.
  double huber = 3.0;

  int max_num_iterations = 300;
};

struct BundleAdjustmentSummary {
  bool is_usable = false;
  std::string message;

  std::vector<Pose> world_from_camera;  // one for each frame, as given
  std::vector<PoseCovariance> pose_covariance;
  MarkerMap map;  // with the free markers' new places

  // Of the free markers, in rising order of their ids.
  std::vector<int> free_ids;
  std::vector<PoseCovariance> marker_covariance;

  // From the residuals over their frames' noise scales: sum of squares / (2 per corner - 6 per pose
  // - 6 per free marker) [px]; the covariances are those of this sigma.
  double corner_sigma = std::numeric_limits<double>::quiet_NaN();
  double corner_sigma_std = std::numeric_limits<double>::quiet_NaN();

  // Root mean square of all corners' distances from where they are drawn, per frame [px].
  std::vector<double> frame_rms;

  int num_iterations = 0;
};

}  // namespace fathom
