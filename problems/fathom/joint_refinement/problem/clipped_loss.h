// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>

namespace fathom {

// How a detection counts whose squared residual, in standard deviations and over all eight rows, is
// s: squared up to `limit`, by its logarithm beyond. Good detections are left as they are; the pull
// of a wild one falls with its distance.
//
//   rho(s) = s                          s <= limit
//   rho(s) = limit (1 + log(s / limit)) otherwise           docs/joint_refinement.md (7)
struct ClippedLoss {
  double value = 0.0;
  double weight = 1.0;  // d rho / d s
  double second_derivative = 0.0;

  static ClippedLoss Of(double s, double limit) {
    if (s <= limit) return {s, 1.0, 0.0};
    return {limit * (1.0 + std::log(s / limit)), limit / s, -limit / (s * s)};
  }
};

}  // namespace fathom
