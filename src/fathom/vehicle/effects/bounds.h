// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <limits>

namespace fathom {

// A bound that is none.
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

// As a null: at any value, as long as the amounts are at theirs.
inline constexpr double kAny = std::numeric_limits<double>::quiet_NaN();

}  // namespace fathom
