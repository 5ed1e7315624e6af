// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/recording.h"
#include "fathom/import/suggest/suggested_map.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <optional>

namespace fathom {

// The map of a telemetry log (.tlog): servo outputs (SERVO_OUTPUT_RAW) at the battery's voltage
// (SYS_STATUS), velocity and position of the EKF (LOCAL_POSITION_NED), attitude and rates
// (ATTITUDE). Ready where it has both, the settings that it heard (PARAM_VALUE) say which output
// drives which motor, and the vehicle is known, whose thrusters are the motors: all of these send
// pulses.
SuggestedMap TlogMap(const Recording& recording, const std::optional<Vehicle>& vehicle);

}  // namespace fathom
