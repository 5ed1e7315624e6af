// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/joint_refinement/motion/global_columns.h"
#include "fathom/joint_refinement/processes/second_order_process.h"

#include <array>

namespace fathom {

// How a held coordinate wanders about its mean response. A std of 0: it does not.
struct HeldWander {
  double std = 0.0;        // [m] or [rad]
  double frequency = 0.5;  // natural [rad/s]
  double ratio = 1.0;      // of damping to critical damping

  bool IsPresent() const { return std > 0.0; }
};

// What is assumed about everything that the model does not predict; docs/joint_refinement.md, "What
// the other coordinates do". All of it is estimated from the data.
struct ProcessSet {
  double corner_sigma = 1.0;  // of a corner's coordinate [px]

  std::array<HeldWander, kNumHeld> wander = {};

  // Standard deviation of what a held coordinate does per scaled displacement, velocity and
  // acceleration of the excited DOF [m] or [rad]; 0: it does not respond.
  std::array<double, kNumHeld> response_std = {};

  // Random acceleration of the excited DOF that the model misses: white, of this intensity
  // [m^2/s^3] or [rad^2/s^3] (0: none), in a vehicle with this damping rate [1/s].
  double model_error = 0.0;
  double damping_rate = 0.1;

  // Of held slot `j`.
  SecondOrderProcess Wander(int j) const {
    return SecondOrderProcess::Held(wander[j].std, wander[j].frequency, wander[j].ratio);
  }
  SecondOrderProcess ModelError() const { return {0.0, damping_rate, model_error}; }

  // Of a coordinate, where `excited` is the one that is not held.
  SecondOrderProcess Of(int coordinate, int excited) const {
    if (coordinate == excited) return ModelError();
    return Wander(coordinate < excited ? coordinate : coordinate - 1);
  }
};

}  // namespace fathom
