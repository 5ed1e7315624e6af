// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/search/work_limit.h"

#include <algorithm>
#include <cmath>

namespace fathom {

bool IsSpent(const SearchTask& task, const HypothesisBook& book) {
  constexpr double kUsual = 300.0;  // [s]
  const SearchOptions& options = task.options;
  const double gain_per_bin = book.MostGain() / static_cast<double>(task.data.bins().size());
  const double share = gain_per_bin > options.much_per_bin ? 1.0 : options.share_of_work;
  const double length = std::max(1.0, std::sqrt(task.data.duration() / kUsual));
  return static_cast<double>(task.data.work() - task.begun) >
         share * task.wanted.effort * options.most_work * length;
}

}  // namespace fathom
