// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/values/equal_runs.h"

namespace fathom {

std::vector<EqualRun> EqualRunsOf(std::span<const double> values) {
  std::vector<EqualRun> runs;
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (row > 0 && values[row] == values[row - 1]) {
      runs.back().last = row;
    } else {
      runs.push_back({row, row});
    }
  }
  return runs;
}

}  // namespace fathom
