// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/noise/noise_model.h"

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace fathom {

// Kinds of noise in residuals that miss nothing: white, AR(1) with 0.9 at 10 Hz, and white with a
// disturbance of (std of v' / white std, tau), a = 0.1 / s.
struct NullNoise {
  std::string name;
  NoiseModel model;
};

inline std::vector<NullNoise> NullNoises() {
  std::vector<NullNoise> noises;
  NoiseModel model;
  model.velocity.white_std = 0.02;
  noises.push_back({"white", model});
  // AR(1) 0.9 at 10 Hz.
  model.velocity = {.white_std = 1e-6, .coloured = {.std = 0.02, .time = -0.1 / std::log(0.9)}};
  noises.push_back({"AR(1) 0.9", model});
  for (const double ratio : {0.1, 0.3, 1.0, 2.0}) {
    for (const double tau : {1.0, 3.0, 10.001, 30.0}) {
      NoiseModel disturbed;
      disturbed.velocity.white_std = 0.02;
      disturbed.damping_rate = 0.1;
      disturbed.disturbance = {.std = 1.0, .time = tau};
      disturbed.disturbance.std = ratio * 0.02 / disturbed.DisturbedVelocityStd();
      char name[64];
      std::snprintf(name, sizeof(name), "%.1f, tau %.0f s", ratio, tau);
      noises.push_back({name, disturbed});
    }
  }
  return noises;
}

}  // namespace fathom
