// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/held_command.h"

#include <algorithm>

namespace fathom {

double HeldCommand::At(double t) const {
  const auto next = std::upper_bound(time.begin(), time.end(), t);
  return next == time.begin() ? 0.0 : value[next - time.begin() - 1];
}

}  // namespace fathom
