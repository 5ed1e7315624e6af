// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/filters/integral.h"

#include <algorithm>

namespace fathom {

std::vector<double> Integral(std::span<const double> time, std::span<const double> values) {
  std::vector<double> integral(time.size(), 0.0);
  for (size_t i = 1; i < time.size(); ++i) {
    integral[i] = integral[i - 1] + 0.5 * (time[i] - time[i - 1]) * (values[i] + values[i - 1]);
  }
  return integral;
}

CommandIntegrals IntegralsOf(const HeldCommand& command, std::span<const double> time) {
  CommandIntegrals integrals;
  if (time.empty()) return integrals;
  integrals.once.reserve(time.size());
  integrals.twice.reserve(time.size());
  double t = time.front(), once = 0.0, twice = 0.0;
  double value = command.At(t);
  size_t next =
      std::upper_bound(command.time.begin(), command.time.end(), t) - command.time.begin();
  const auto advance = [&](double to) {
    const double h = to - t;
    twice += h * (once + 0.5 * h * value);
    once += h * value;
    t = to;
  };
  for (const double stamp : time) {
    for (; next < command.time.size() && command.time[next] <= stamp; ++next) {
      advance(command.time[next]);
      value = command.value[next];
    }
    advance(stamp);
    integrals.once.push_back(once);
    integrals.twice.push_back(twice);
  }
  return integrals;
}

}  // namespace fathom
