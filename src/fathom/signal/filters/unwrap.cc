// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/filters/unwrap.h"

#include <cmath>
#include <numbers>

namespace fathom {

std::vector<double> Unwrap(std::span<const double> angles) {
  std::vector<double> unwrapped;
  unwrapped.reserve(angles.size());
  for (const double angle : angles) {
    const double before = unwrapped.empty() ? angle : unwrapped.back();
    unwrapped.push_back(before + std::remainder(angle - before, 2.0 * std::numbers::pi));
  }
  return unwrapped;
}

}  // namespace fathom
