// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/held_command.h"

#include <algorithm>
#include <cstddef>

namespace fathom {

double HeldCommand::At(double t) const {
  const auto next = std::upper_bound(time.begin(), time.end(), t);
  return next == time.begin() ? 0.0 : value[next - time.begin() - 1];
}

HeldCommand HeldCommand::Between(double from, double to) const {
  const auto next = std::upper_bound(time.begin(), time.end(), from);
  const auto begin = std::max<std::ptrdiff_t>(next - time.begin() - 1, 0);
  const auto end = std::upper_bound(time.begin(), time.end(), to) - time.begin();
  return {{time.begin() + begin, time.begin() + end}, {value.begin() + begin, value.begin() + end}};
}

}  // namespace fathom
