// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/experiment/correlated_noise.h"

#include <cmath>

namespace fathom {

double CorrelatedNoise::Next() {
  const double fresh = random_.Normal();
  last_ = is_first_ ? fresh
                    : correlation_ * last_ + std::sqrt(1.0 - correlation_ * correlation_) * fresh;
  is_first_ = false;
  return last_;
}

}  // namespace fathom
