// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/log.h"

#include <string>

namespace fathom {

inline constexpr double kAftOfSteeredLog = -2.0;   // where the rudder is [m]
inline constexpr double kAheadOfSteeredLog = 1.5;  // speed [m/s]

// 5 s of a vehicle with one rudder under 5 N ahead, in a folder of the running test. `size`: a line
// of the vehicle file, or empty.
Log SteeredLog(const std::string& size);

}  // namespace fathom
