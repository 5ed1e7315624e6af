// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/geometry/pose.h"
#include "fathom/log/log.h"

#include <limits>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// A pose at a time, with what is known of its error.
struct StampedPose {
  double time = 0.0;  // [s]
  Pose pose;

  // Of (translation, rotation vector about the axes of the moving frame), [m] and [rad]:
  // true pose = {R exp(rotation), p + translation}. NaN where unknown.
  Eigen::Matrix<double, 6, 6> covariance =
      Eigen::Matrix<double, 6, 6>::Constant(std::numeric_limits<double>::quiet_NaN());
};

// The poses as the stream of a log: x y z qx qy qz qw, then the standard deviations sx sy sz [m]
// (along the world's axes) sroll spitch syaw [rad] (about the body's), if all poses have them.
Stream PoseStreamOf(const std::vector<StampedPose>& poses);

}  // namespace fathom
