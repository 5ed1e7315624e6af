// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

namespace fathom {

// A stream of samples, linear in between and held beyond its ends.
struct SampledSignal {
  std::vector<double> time;  // [s], strictly increasing
  std::vector<double> value;
};

}  // namespace fathom
