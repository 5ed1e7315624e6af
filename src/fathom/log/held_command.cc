// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/held_command.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace fathom {

double HeldCommand::At(double t) const {
  const auto next = std::upper_bound(time.begin(), time.end(), t);
  return next == time.begin() ? 0.0 : value[next - time.begin() - 1];
}

std::vector<double> HeldCommand::At(std::span<const double> stamps) const {
  if (stamps.empty()) return {};
  const auto first = std::upper_bound(time.begin(), time.end(), stamps.front());
  auto num_given = static_cast<std::size_t>(first - time.begin());
  std::vector<double> values;
  values.reserve(stamps.size());
  for (const double t : stamps) {
    while (num_given < time.size() && time[num_given] <= t) ++num_given;
    values.push_back(num_given > 0 ? value[num_given - 1] : 0.0);
  }
  return values;
}

HeldCommand HeldCommand::Between(double from, double to) const {
  const auto next = std::upper_bound(time.begin(), time.end(), from);
  const auto begin = std::max<std::ptrdiff_t>(next - time.begin() - 1, 0);
  const auto end = std::upper_bound(time.begin(), time.end(), to) - time.begin();
  return {{time.begin() + begin, time.begin() + end}, {value.begin() + begin, value.begin() + end}};
}

}  // namespace fathom
