// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/findings/finding.h"
#include "fathom/log/log.h"

#include <vector>

namespace fathom {

// Whether the fins of a log turn by more than a right angle: they are logged in degrees then.
std::vector<Finding> CheckFins(const Log& log);

}  // namespace fathom
