// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/experiment/resolution.h"

#include <cmath>

namespace fathom {

double RoundTo(double value, double resolution) {
  if (resolution == 0.0) return value;
  const double steps_per_unit = std::round(1.0 / resolution);
  const bool divides_one = std::abs(steps_per_unit * resolution - 1.0) < 1e-9;
  const double rounded = divides_one ? std::round(value * steps_per_unit) / steps_per_unit
                                     : std::round(value / resolution) * resolution;
  return rounded + 0.0;  // -0 becomes 0
}

}  // namespace fathom
