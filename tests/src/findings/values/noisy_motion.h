// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

namespace fathom {

// A speed that swings by 0.5 m/s with a period of 20 s, measured at 10 Hz with noise of 0.02 m/s.
struct NoisyMotion {
  std::vector<double> time, value;
};
NoisyMotion NoisyMotionOf(int num_rows, unsigned seed = 1);

// The same rounded to `resolution`.
std::vector<double> Rounded(std::vector<double> values, double resolution);

}  // namespace fathom
