// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/thinning.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glog/logging.h>

namespace fathom {

std::vector<std::size_t> ThinnedIndices(const std::vector<std::vector<double>>& curves,
                                        std::size_t num_stamps,
                                        std::size_t most) {
  if (num_stamps <= most) {
    std::vector<std::size_t> all(num_stamps);
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
  }
  const std::size_t num_runs = (most - 2) / (3 * std::max<std::size_t>(curves.size(), 1));
  CHECK_GT(num_runs, 0u);

  std::vector<std::size_t> kept = {0, num_stamps - 1};
  for (std::size_t run = 0; run < num_runs; ++run) {
    const std::size_t begin = run * num_stamps / num_runs;
    const std::size_t end = (run + 1) * num_stamps / num_runs;
    for (const std::vector<double>& curve : curves) {
      std::size_t highest = end;
      std::size_t lowest = end;
      std::size_t missing = end;
      for (std::size_t i = begin; i < end; ++i) {
        if (std::isnan(curve[i])) {
          if (missing == end) missing = i;
          continue;
        }
        if (highest == end || curve[i] > curve[highest]) highest = i;
        if (lowest == end || curve[i] < curve[lowest]) lowest = i;
      }
      for (const std::size_t index : {highest, lowest, missing}) {
        if (index != end) kept.push_back(index);
      }
    }
  }
  std::ranges::sort(kept);
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  return kept;
}

}  // namespace fathom
