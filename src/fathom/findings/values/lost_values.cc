// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/values/lost_values.h"

#include "fathom/findings/values/equal_runs.h"
#include "fathom/findings/values/large_jump.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace fathom {
namespace {

constexpr std::size_t kFewestLostRows = 3;

// The sizes of the steps between values that follow each other when zeros are passed over.
std::vector<double> StepsOf(std::span<const double> values) {
  std::vector<double> steps;
  double before = 0.0;
  for (const double value : values) {
    if (value == 0.0) continue;
    if (before != 0.0 && value != before) steps.push_back(std::abs(value - before));
    before = value;
  }
  return steps;
}

}  // namespace

std::optional<LostValues> FindLostValues(std::span<const double> values) {
  const double far = LargeJump(StepsOf(values));
  if (!(far > 0.0)) return std::nullopt;
  LostValues lost;
  for (const EqualRun& run : EqualRunsOf(values)) {
    if (values[run.first] != 0.0 || run.first == 0 || run.last + 1 == values.size()) continue;
    const double before = std::abs(values[run.first - 1]), after = std::abs(values[run.last + 1]);
    if (!(std::min(before, after) > far)) continue;
    if (lost.num_rows == 0) lost.first = run.first;
    lost.num_rows += run.NumRows();
  }
  if (lost.num_rows < kFewestLostRows) return std::nullopt;
  return lost;
}

}  // namespace fathom
