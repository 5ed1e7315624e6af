// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/coupled/attitude_angles.h"

#include <cmath>
#include <numbers>

namespace fathom {

double TiltOf(const CoupledState& state) {
  const Eigen::Vector4d& q = state.attitude;
  // The cosine of half the angle is the length of (z, w).
  return 2.0 * std::atan2(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
}

double UnwrappedHeading(const CoupledState& state, double before) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  const Eigen::Vector4d& q = state.attitude;
  const double heading =
      std::atan2(2.0 * (q[3] * q[2] + q[0] * q[1]), 1.0 - 2.0 * (q[1] * q[1] + q[2] * q[2]));
  return heading - kTurn * std::round((heading - before) / kTurn);
}

}  // namespace fathom
