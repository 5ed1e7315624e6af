// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/findings/finding.h"
#include "fathom/log/log.h"

#include <vector>

namespace fathom {

// Steps of pose.csv that last and that no vehicle makes: an estimator that was realigned, a marker
// whose place is wrong; docs/findings.md.
//
//   pose_jump   warning  a position or the yaw is from one row to the next somewhere else, by over
//                        0.1 m or 0.1 rad and ten large steps (the 90 % quantile), and stays there
//
// A pose that flips for some rows and comes back is none.
std::vector<Finding> CheckPoseJumps(const Log& log);

}  // namespace fathom
