// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/findings/finding.h"
#include "fathom/log/log.h"

#include <optional>

namespace fathom {

// Attitudes of pose.csv that turn away and back as no vehicle does: a rigid body or a marker that
// looks alike from several sides; docs/findings.md.
//
//   pose_flip   note  from one row to the next it turns by over 30 degrees, and is back within half
//                     a second
std::optional<Finding> CheckPoseFlips(const Log& log);

}  // namespace fathom
