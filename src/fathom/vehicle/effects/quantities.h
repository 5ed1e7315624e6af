// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/effect.h"

namespace fathom {

// The quantities that effects' parameters are; {linear unit, angular unit, powers of force, speed
// and time}.
inline constexpr Quantity kRatio = {"-", "-"};
inline constexpr Quantity kDuration = {"s", "s", 0, 0, 1};
inline constexpr Quantity kRate = {"1/s", "1/s", 0, 0, -1};
inline constexpr Quantity kFrequency = {"rad/s", "rad/s", 0, 0, -1};
inline constexpr Quantity kAngle = {"rad", "rad"};
inline constexpr Quantity kSpeed = {"m/s", "rad/s", 0, 1, 0};
inline constexpr Quantity kLength = {"m", "rad", 0, 1, 1};
inline constexpr Quantity kArm = {"m", "m"};  // of a rotation rate
inline constexpr Quantity kForce = {"N", "N m", 1, 0, 0};
inline constexpr Quantity kForceRate = {"N/s", "N m/s", 1, 0, -1};
inline constexpr Quantity kStiffness = {"N/m", "N m/rad", 1, -1, -1};
// Of the sine of an angle. A stiffness in size: the command need not reach it, as it does a force.
inline constexpr Quantity kMomentOfSine = {"N", "N m", 1, -1, -1};
inline constexpr Quantity kLinearDrag = {"kg/s", "kg m^2/s", 1, -1, 0};
inline constexpr Quantity kCubicDrag = {"N s^3/m^3", "N m s^3/rad^3", 1, -3, 0};
inline constexpr Quantity kMass = {"kg", "kg m^2", 1, -1, 1};
inline constexpr Quantity kInflow = {"sqrt(N) s/m", "sqrt(N m) s/rad", 0.5, -1, 0};

}  // namespace fathom
