// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/noise/noise_model.h"

#include <array>

namespace fathom {

// What a Whitener does from one sample to the next. The state holds only what the model and the
// samples need of (w, v', x', coloured velocity noise, coloured displacement noise), in this order.
struct WhiteningStep {
  // Entries of the transition, all 0 at the start of a segment.
  double w_from_w, v_from_w, v_from_v, x_from_w, x_from_v, x_from_x, velocity_c, displacement_c;
  double inverse_std;          // of the innovation
  std::array<double, 5> gain;  // of the state, on the whitened innovation
  NoiseChannel channel;
};

}  // namespace fathom
