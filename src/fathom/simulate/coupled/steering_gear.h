// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace fathom {

// What a rudder does within a step of time.
struct GearStep {
  double mean = 0.0;  // angle over the step [rad]
  double end = 0.0;   // angle at its end [rad]
};

// A rudder that turns from `angle` to `order` [rad] at `rate` [rad/s], above 0 and perhaps
// infinite, from `wait` [s] after the step's begin on, within 0 and `step` [s].
GearStep TurnRudder(double angle, double order, double rate, double wait, double step);

}  // namespace fathom
