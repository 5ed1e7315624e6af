// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <limits>

namespace fathom {

// How large things are in one DOF of an experiment in which nothing is hidden.
struct Scales {
  double force = 0.0;       // RMS command [N] or [N m]
  double peak_force = 0.0;  // its largest, either sign
  double force_rate = 0.0;  // how much it changes in the mean, either sign [N/s] or [N m/s]
  double speed = 0.0;       // RMS [m/s] or [rad/s]
  double place = 0.0;       // mean position [m] or [rad]
  double length = 0.0;      // RMS distance from there
  double duration = 0.0;    // [s]
};

// The scales that an effect's parameter may be measured by.
struct NaturalScales {
  const Scales& own;      // of the DOF that the effect is in
  const Scales& partner;  // of the DOF that takes part
  const Scales& yaw;
};

// One natural size of a parameter, in its unit.
using NaturalUnit = double (*)(const NaturalScales& scales);

// From just visible in a log to large, in natural units. What is drawn from it is even in its
// logarithm.
struct SizeRange {
  double smallest = std::numeric_limits<double>::quiet_NaN();
  double largest = std::numeric_limits<double>::quiet_NaN();
  NaturalUnit unit = nullptr;  // null: the effect cannot be drawn
  bool either_sign = false;    // true: either sign is physical
};

}  // namespace fathom
