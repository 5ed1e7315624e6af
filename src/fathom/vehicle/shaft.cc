// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/shaft.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fathom {
namespace {

constexpr double kRhoOfWater = 1000.0;  // [kg/m^3]

// K_T as at_rest + slope J, about a J.
struct CurveLine {
  double at_rest = 1.0;
  double slope = 0.0;
};

CurveLine LineOf(const Shaft& shaft, double advance) {
  if (!shaft.curve) return {};
  const OpenWaterCurve& curve = *shaft.curve;
  if (advance < 0.0 || curve.advance.size() < 2) return {curve.thrust.front(), 0.0};
  const auto next = std::upper_bound(curve.advance.begin() + 1, curve.advance.end() - 1, advance);
  const auto k = static_cast<std::size_t>(next - curve.advance.begin());
  const double slope =
      (curve.thrust[k] - curve.thrust[k - 1]) / (curve.advance[k] - curve.advance[k - 1]);
  return {curve.thrust[k] - slope * curve.advance[k], slope};
}

}  // namespace

// With K_T = a + b J the thrust is rho D^4 (a n |n| + b (1 - w) u |n| / D).
ShaftThrust ShaftThrustAt(const Shaft& shaft, double revolutions, double speed) {
  if (revolutions == 0.0) return {};
  const double inflow = 1.0 - shaft.wake.value_or(0.0);
  const double D = shaft.diameter, n = revolutions;
  const CurveLine line = LineOf(shaft, inflow * speed / (n * D));
  ShaftThrust at;
  at.by_speed = kRhoOfWater * D * D * D * line.slope * inflow * std::abs(n);
  at.thrust = kRhoOfWater * D * D * D * D * line.at_rest * n * std::abs(n) + at.by_speed * speed;
  return at;
}

}  // namespace fathom
