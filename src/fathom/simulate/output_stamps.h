// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <vector>

namespace fathom {

// When the run starts and where its outputs are wanted, in log time [s].
struct OutputStamps {
  double start = 0.0;
  std::vector<double> velocity;      // strictly increasing, from `start` on
  std::vector<double> displacement;  // strictly increasing, from `start` on

  // From the start to the last of either [s].
  double Duration() const {
    const double last_velocity = velocity.empty() ? start : velocity.back();
    const double last_displacement = displacement.empty() ? start : displacement.back();
    return std::max(last_velocity, last_displacement) - start;
  }
};

}  // namespace fathom
