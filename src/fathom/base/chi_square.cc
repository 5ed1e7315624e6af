// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/chi_square.h"

#include <cmath>

namespace fathom {

double ChiSquareTail(double value, int freedom) {
  if (freedom <= 0 || value <= 0.0) return 1.0;
  // Q(a + 1, x) = Q(a, x) + x^a e^-x / Gamma(a + 1), from a = 1/2 or 1 on.
  const double x = value / 2.0;
  double a = freedom % 2 == 1 ? 0.5 : 1.0;
  double tail = freedom % 2 == 1 ? std::erfc(std::sqrt(x)) : std::exp(-x);
  for (; a < freedom / 2.0 - 0.25; a += 1.0) {
    tail += std::exp(a * std::log(x) - x - std::lgamma(a + 1.0));
  }
  return tail;
}

}  // namespace fathom
