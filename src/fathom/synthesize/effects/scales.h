// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

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

}  // namespace fathom
