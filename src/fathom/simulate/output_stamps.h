// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

namespace fathom {

// When the run starts and where its outputs are wanted, in log time [s].
struct OutputStamps {
  double start = 0.0;
  std::vector<double> velocity;      // strictly increasing, from `start` on
  std::vector<double> displacement;  // strictly increasing, from `start` on
};

}  // namespace fathom
