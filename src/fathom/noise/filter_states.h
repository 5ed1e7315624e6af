// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/noise/noise_model.h"

namespace fathom {

// Which states of the noise a filter carries, and where: the first `kDisturbance` (0, 2 or 3) of
// (w, v', x'), then the coloured noises that there are.
template <int kDisturbance, bool kVelocityC, bool kDisplacementC>
struct FilterStates {
  static constexpr bool kHasV = kDisturbance >= 2, kHasX = kDisturbance == 3;
  static constexpr bool kHasC = kVelocityC, kHasCx = kDisplacementC;
  static constexpr int kW = 0, kV = 1, kX = 2;
  static constexpr int kC = kDisturbance, kCx = kC + (kVelocityC ? 1 : 0);
  static constexpr int kNumStates = kCx + (kDisplacementC ? 1 : 0);

  // The states that a channel sees, each with factor 1: calls function(index) for them.
  template <typename Function>
  static void ForSeen(NoiseChannel channel, const Function& function) {
    if (channel == NoiseChannel::kVelocity) {
      if constexpr (kHasV) function(kV);
      if constexpr (kHasC) function(kC);
    } else {
      if constexpr (kHasX) function(kX);
      if constexpr (kHasCx) function(kCx);
    }
  }
};

}  // namespace fathom
