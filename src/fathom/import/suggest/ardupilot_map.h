// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/recording.h"
#include "fathom/import/suggest/suggested_map.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <optional>

namespace fathom {

// The map of an ArduSub log: thruster outputs (RCOU) at the battery's voltage (BAT), velocity and
// pose of the EKF (XKF1, or NKF1 of old logs) and rates of the gyros (IMU). Ready where it has
// both, the settings say which output drives which motor, and the vehicle is known, whose thrusters
// are the motors: all of these send pulses.
SuggestedMap ArdupilotMap(const Recording& recording, const std::optional<Vehicle>& vehicle);

}  // namespace fathom
