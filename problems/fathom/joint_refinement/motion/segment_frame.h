// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/camera/marker_map.h"
#include "fathom/geometry/pose.h"

#include <span>

namespace fathom {

// world_from_frame of a segment: a frame at the world's origin with the attitude that the vehicle
// keeps during the segment. In it the excited DOF moves the coordinate of its own index, whatever
// way the vehicle heads in the world; along an axis that is off by an angle a, a motion would look
// smaller by cos a, and the vehicle heavier.
Pose SegmentFrameOf(Dof dof, std::span<const Pose> world_from_body);

// The markers with their places in that frame instead of the world.
MarkerMap MapIn(const Pose& frame_from_world, const MarkerMap& map);

}  // namespace fathom
