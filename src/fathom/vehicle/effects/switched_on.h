// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace fathom {

// 0 before, 1 after: what switches at a time does so over 0.2 s about it, so that a fit can move
// the time.
template <typename T>
T SwitchedOn(const T& seconds_since) {
  constexpr double kWidth = 0.2;
  if (seconds_since < T(-0.5 * kWidth)) return T(0.0);
  if (seconds_since > T(0.5 * kWidth)) return T(1.0);
  return seconds_since / kWidth + 0.5;
}

}  // namespace fathom
