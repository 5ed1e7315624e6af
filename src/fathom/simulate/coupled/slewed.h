// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>

namespace fathom {

// An angle that follows its command no faster than a rate,
//
//   abs(dx/dt) <= rate,
//
// while the target holds: a ramp up to it; with its derivative by the rate.
struct Slewed {
  double target = 0.0;         // what the command asks for [rad]
  double begun = 0.0;          // x where the target began to hold [rad]
  double begun_by_rate = 0.0;  // its derivative [s]

  bool Moves() const { return begun != target; }

  // How long it takes to the target [s].
  double Needed(double rate) const { return std::abs(target - begun) / rate; }

  // After `t` s of this target, not beyond Needed() [rad].
  double At(double t, double rate) const {
    return Moves() ? begun + std::copysign(rate * t, target - begun) : target;
  }

  // By the rate [s].
  double ByRate(double t) const {
    return Moves() ? begun_by_rate + std::copysign(t, target - begun) : 0.0;
  }

  // By the time [rad/s].
  double Speed(double rate) const { return Moves() ? std::copysign(rate, target - begun) : 0.0; }

  // It is at its target.
  void Arrive() {
    begun = target;
    begun_by_rate = 0.0;
  }

  // Another target from here on, `t` s after this one.
  void Retarget(double next, double t, double rate) {
    if (Needed(rate) <= t) Arrive();
    const double by_rate = ByRate(t);
    begun = At(t, rate);
    begun_by_rate = by_rate;
    target = next;
  }
};

}  // namespace fathom
