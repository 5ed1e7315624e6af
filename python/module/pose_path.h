// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/geometry/stamped_pose.h"

#include <vector>

namespace fathom {

// Poses with stamps and covariances, as Python sees them: fathom.Trajectory.
struct PosePath {
  std::vector<StampedPose> poses;  // world_from_body, or world_from_camera; by time
};

}  // namespace fathom
