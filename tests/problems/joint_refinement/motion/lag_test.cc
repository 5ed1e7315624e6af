// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/motion/lag.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

// T y' + y = p + q t has the solution p + q (t - T) + c exp(-t / T), and starts at y = p.
TEST(Lag, FollowsARampAtUnevenStamps) {
  constexpr double kT = 1.7, kOffset = 0.4, kSlope = -0.3;
  const std::vector<double> time = {2.0, 2.1, 2.15, 3.4, 6.0, 6.003, 21.0};
  SignalRows signals(7, 2);
  for (int k = 0; k < 7; ++k) {
    signals(k, 0) = kOffset + kSlope * (time[k] - 2.0);
    signals(k, 1) = 5.0;
  }
  const SignalRows lagged = Lagged(time, kT, signals);
  for (int k = 0; k < 7; ++k) {
    const double t = time[k] - 2.0;
    EXPECT_NEAR(lagged(k, 0), kOffset + kSlope * (t - kT + kT * std::exp(-t / kT)), 1e-12);
    EXPECT_NEAR(lagged(k, 1), 5.0, 1e-12);
  }
}

// A sine comes out smaller by 1/sqrt(1 + (w T)^2) and later by atan(w T).
TEST(Lag, TurnsASine) {
  constexpr double kT = 0.5, kFrequency = 1.3;
  std::vector<double> time;
  SignalRows signals(4000, 1);
  for (int k = 0; k < 4000; ++k) {
    time.push_back(0.01 * k);
    signals(k, 0) = std::sin(kFrequency * time[k]);
  }
  const SignalRows lagged = Lagged(time, kT, signals);
  const double gain = 1.0 / std::hypot(1.0, kFrequency * kT), phase = std::atan(kFrequency * kT);
  for (int k = 1000; k < 4000; k += 37) {
    // The chords of the sine are off by (w h)^2 / 8.
    EXPECT_NEAR(lagged(k, 0), gain * std::sin(kFrequency * time[k] - phase), 3e-5);
  }
}

}  // namespace
}  // namespace fathom
