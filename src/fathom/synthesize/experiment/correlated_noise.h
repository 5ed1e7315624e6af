// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/random_stream.h"

namespace fathom {

// Stationary normal noise of standard deviation 1 from sample to sample:
//
//   x_0 = e_0,   x_k = a x_{k-1} + sqrt(1 - a^2) e_k,   e white   docs/synthesize.md (8)
class CorrelatedNoise {
 public:
  CorrelatedNoise(RandomStream random, double correlation)
      : random_(random), correlation_(correlation) {}

  double Next();

 private:
  RandomStream random_;
  double correlation_;
  double last_ = 0.0;
  bool is_first_ = true;
};

}  // namespace fathom
