// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/recording.h"
#include "fathom/import/suggest/suggested_map.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <optional>

namespace fathom {

// The map of a file of ROS by the types of its topics: a wrench for the command, odometry, twist or
// inertial rates for the velocity, odometry or a pose for the pose. ROS's conventions hold for the
// axes: body x forward, y left, z up; world east, north, up (REP 103). Ready where there is one
// odometry and one wrench, so that nothing had to be chosen.
SuggestedMap RosMap(const Recording& recording, const std::optional<Vehicle>& vehicle);

}  // namespace fathom
