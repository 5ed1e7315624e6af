// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/time_interval.h"

#include <vector>

namespace fathom {

// What --held_out asks for, "240:300" or "100:120,240:300", for HoldOut(); nothing if it is not
// given. Throws InputError for anything else.
std::vector<TimeInterval> HeldOutFromFlag();

}  // namespace fathom
