// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/coupled/six_vector.h"

#include <cmath>

namespace fathom {

// What a wrench changes by, for each radian that it is turned further about z.
inline Vector6 ByTurnAboutZ(const Vector6& wrench) {
  Vector6 by;
  by << -wrench[1], wrench[0], 0.0, -wrench[4], wrench[3], 0.0;
  return by;
}

// A wrench turned about z by an angle [rad], right-handed: along z, which points down, from ahead
// to starboard.
inline Vector6 TurnedAboutZ(double angle, const Vector6& wrench) {
  Vector6 turned = std::cos(angle) * wrench + std::sin(angle) * ByTurnAboutZ(wrench);
  turned[2] = wrench[2];
  turned[5] = wrench[5];
  return turned;
}

}  // namespace fathom
