// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/coupled/steering_gear.h"

#include <cmath>

namespace fathom {

GearStep TurnRudder(double angle, double order, double rate, double wait, double step) {
  const double way = order - angle, left = step - wait;
  const double needed = std::abs(way) / rate;
  if (needed > left) {
    const double turned = std::copysign(rate * left, way);
    return {angle + 0.5 * turned * left / step, angle + turned};
  }
  return {angle + way * (left - 0.5 * needed) / step, order};
}

}  // namespace fathom
