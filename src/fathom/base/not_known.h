// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <limits>

namespace fathom {

// A number that was not measured or not computed.
inline constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();

}  // namespace fathom
