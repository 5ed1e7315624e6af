// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "binomial.h"

#include <cmath>

namespace fathom::hidden {
namespace {

// The p at which `chance`, which falls with p, is `wanted`.
template <typename Chance>
double Solve(const Chance& chance, double wanted) {
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (chance(middle) > wanted ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

double AtMost(int count, int trials, double p) {
  if (count < 0) return 0.0;
  if (count >= trials || p <= 0.0) return 1.0;
  if (p >= 1.0) return 0.0;
  double sum = 0.0;
  for (int k = 0; k <= count; ++k) {
    sum +=
        std::exp(std::lgamma(trials + 1.0) - std::lgamma(k + 1.0) - std::lgamma(trials - k + 1.0) +
                 k * std::log(p) + (trials - k) * std::log1p(-p));
  }
  return sum;
}

Interval ClopperPearson(int count, int trials, double confidence) {
  if (trials == 0) return {};
  const double tail = 0.5 * (1.0 - confidence);
  Interval interval;
  if (count > 0) {
    interval.low = Solve([&](double p) { return AtMost(count - 1, trials, p); }, 1.0 - tail);
  }
  if (count < trials) {
    interval.high = Solve([&](double p) { return AtMost(count, trials, p); }, tail);
  }
  return interval;
}

int FewestExpected(int trials, double p, double error) {
  int count = 0;
  while (count < trials && AtMost(count, trials, p) < error) ++count;
  return count;
}

int MostExpected(int trials, double p, double error) {
  int count = 0;
  while (count < trials && 1.0 - AtMost(count, trials, p) >= error) ++count;
  return count;
}

}  // namespace fathom::hidden
