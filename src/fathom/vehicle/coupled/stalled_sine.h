// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>

namespace fathom {

// What stall leaves of the sine y of an angle of attack, docs/fins.md (3): it stops growing at the
// sine L of the angle at which the fin stalls. In between a parabola leads over, so that the slope
// does not jump.
//
//   abs(y) <= (1 - e) L            y
//   abs(y) <  (1 + e) L            y - (y - (1 - e) L)^2 / (4 e L)     with the sign of y
//   beyond                         L                                   with the sign of y
struct StalledSine {
  static constexpr double kBend = 0.1;  // e

  double value = 0.0;
  double by_sine = 1.0;   // by y
  double by_limit = 0.0;  // by L
};

inline StalledSine StalledSineOf(double sine, double limit) {
  const double size = std::abs(sine), bends = (1.0 - StalledSine::kBend) * limit;
  if (size <= bends) return {sine, 1.0, 0.0};
  const double sign = sine < 0.0 ? -1.0 : 1.0;
  if (size >= (1.0 + StalledSine::kBend) * limit) return {sign * limit, 0.0, sign};
  const double beyond = (size - bends) / (4.0 * StalledSine::kBend * limit);
  const double lost = beyond * (size - bends);
  // By L: the square's slope, and that of what divides it.
  const double by_limit = 2.0 * beyond * (1.0 - StalledSine::kBend) + lost / limit;
  return {sign * (size - lost), 1.0 - 2.0 * beyond, sign * by_limit};
}

}  // namespace fathom
