// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/values/large_jump.h"

#include "fathom/base/quantile.h"

#include <utility>

namespace fathom {

double LargeJump(std::vector<double> usual_changes) {
  constexpr double kLarge = 0.9;
  constexpr double kTimesLarge = 5.0;
  if (usual_changes.empty()) return 0.0;
  return kTimesLarge * Quantile(std::move(usual_changes), kLarge);
}

}  // namespace fathom
