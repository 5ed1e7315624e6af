// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/findings/finding.h"
#include "fathom/findings/sensor_mount.h"
#include "fathom/log/log.h"

#include <vector>

namespace fathom {

// What SensorMountOf() these columns of a log tells, where the fit needs it:
//
//   lever_arm       the sensor is off the point of the poses: an arm of over 0.1 m whose 95 %
//                   interval leaves out 0
//   mounting_angle  it is turned about z by over 3 degrees, likewise; a warning over 10 degrees
std::vector<Finding> CheckSensorMount(const SensorMount& mount,
                                      const Log& log,
                                      const std::vector<LateColumn>& columns);

}  // namespace fathom
