// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/findings/finding.h"
#include "fathom/log/log.h"

#include <vector>

namespace fathom {

// Whether the two motions that a log holds are one: each column of velocity.csv against the
// velocity that pose.csv gives; docs/findings.md. A wrong axis, sign or unit of either shows here,
// before any model. All are warnings but the delay.
//
//   pose_twist_frame  the linear columns are along the axes of the world, not of the vehicle; the
//                     others then say nothing of them
//   pose_twist_sign   they have opposite signs
//   pose_twist_scale  one is over 1.25 times the other
//   pose_twist_apart  both move, and not together
//   pose_twist_delay  one is later by over 0.15 s and two samples, up to 3 s
//
// Then CheckSensorMount() of the linear columns.
//
// Nothing of an axis along which either hardly moves, and of a log without both.
std::vector<Finding> CheckPoseAgainstTwist(const Log& log);

}  // namespace fathom
