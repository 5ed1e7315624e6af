// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace fathom {

// Half width of a 95 % interval of a normally distributed number, in standard deviations.
inline constexpr double kStdsOf95 = 1.96;

}  // namespace fathom
