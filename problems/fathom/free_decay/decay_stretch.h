// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

namespace fathom {

// One unbroken piece of the motion of one DOF while nothing drives it.
struct DecayStretch {
  std::vector<double> time;    // [s], strictly increasing
  std::vector<double> motion;  // measured velocity [m/s], or displacement [m]; [rad/s], [rad]
};

enum class DecayOutput { kVelocity, kDisplacement };

}  // namespace fathom
