// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/judge/free_run_ladder.h"

#include "fathom/diagnosis/search/suspects.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace fathom {
namespace {

constexpr size_t kTriedOfSize = 2;

// The best hypotheses of so many causes on the training data.
std::vector<int> ProposedOfSize(const HypothesisBook& book, int size) {
  std::vector<int> proposed = book.RankedOfSize(size);
  std::erase_if(proposed, [&](int index) { return !(book.Worth(index) > 0.0); });
  if (proposed.size() > kTriedOfSize) proposed.resize(kTriedOfSize);
  return proposed;
}

double Total(const std::vector<FreeRun>& runs) {
  double sum = 0.0;
  for (const FreeRun& run : runs) {
    for (size_t i = 0; i < run.time.size(); ++i)
      sum += std::abs(run.predicted[i] - run.measured[i]);
  }
  return sum;
}

}  // namespace

bool IsBetterForCertain(const Gain& gain, const VerdictRules& rules) {
  if (gain.num_logs > 0 && gain.num_better == gain.num_logs)
    return gain.value > rules.material_gain;
  if (std::isnan(gain.low)) return gain.value > rules.material_gain_without_interval;
  return gain.low > rules.material_gain;
}

Rung ClimbByFreeRuns(const Prepared& prepared,
                     const WeighedSearch& search,
                     const std::shared_ptr<const LeftOutParts>& parts,
                     int most_causes,
                     const VerdictRules& rules) {
  const HypothesisBook& book = search.found.book;
  Rung at;
  at.choice.fits[0] = search.baseline;
  bool is_first = true;
  for (int size = 1; size <= most_causes; ++size) {
    Rung best = at;
    for (const int index : ProposedOfSize(book, size)) {
      Rung next;
      next.choice = WithChosen(prepared.data, search, index, at.choice);
      if (next.choice.chosen == 0) continue;
      next.runs = CompareWithUsers(prepared,
                                   parts,
                                   next.choice.fit(),
                                   search.criterion,
                                   ActOnPosesAlone(book[index].suspects, search.suspects));
      if (is_first) at.runs = best.runs = OfUsersAlone(next.runs);
      is_first = false;
      const auto& tried = next.runs.unseen.after;
      const bool is_better =
          AreOverTheSame(at.runs.unseen.after, tried) &&
          IsBetterForCertain(GainOf(Beside(at.runs.unseen, next.runs.unseen), false), rules);
      if (!is_better) continue;
      if (best.choice.chosen == at.choice.chosen || Total(tried) < Total(best.runs.unseen.after)) {
        best = std::move(next);
      }
    }
    at = std::move(best);
  }
  return at;
}

}  // namespace fathom
