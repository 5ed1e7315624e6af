// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/recording.h"
#include "fathom/import/suggest/suggested_map.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <optional>

namespace fathom {

// The map of a PX4 log: motor commands (actuator_motors, shares of full command; or
// actuator_outputs, where they are pulse widths) at the battery's voltage, velocity and position of
// the EKF (vehicle_local_position), its attitude (vehicle_attitude) and rates of the gyros. Ready
// where it has both and the vehicle is known, whose thrusters are the first outputs.
SuggestedMap Px4Map(const Recording& recording, const std::optional<Vehicle>& vehicle);

}  // namespace fathom
