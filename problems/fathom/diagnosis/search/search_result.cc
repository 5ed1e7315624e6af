// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/search/search_result.h"

#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace fathom {
namespace {

constexpr double kExplainsNothing = 0.05;  // p-value of a rival alone
// Under a single sine, causes that differ in phase alone are told apart by what little else there
// is: the start, the shape of the tops. That takes more than usual.
constexpr double kHarderUnderASine = 5.0;

}  // namespace

bool IsPhysical(const Hypothesis& hypothesis) {
  size_t i = kNumParameters;
  for (const ActiveEffect& active : hypothesis.fit.model.effects) {
    for (size_t k = 0; k < active.values.size(); ++k, ++i) {
      // A shape on its bound is one that this log cannot show; at its null an effect is not there.
      const double null = active.effect->info().parameters[k].null;
      if (!std::isnan(null) && active.values[k] != null && hypothesis.fit.is_on_bound[i]) {
        return false;
      }
    }
  }
  return true;
}

double ThresholdOf(const SearchResult& search, const std::vector<int>& suspects) {
  double sum = 0.0, most_spared = 0.0;
  for (const int suspect : suspects) {
    sum += search.thresholds_beside[suspect];
    most_spared =
        std::max(most_spared, search.thresholds_beside[suspect] - search.thresholds[suspect]);
  }
  return sum - most_spared;  // one of them came first
}

std::vector<int> FindRivals(const TrainingData& data,
                            const SearchResult& search,
                            double separation) {
  std::vector<int> rivals;
  if (search.best == 0) return rivals;
  if (data.command_tone().IsAlone()) separation *= kHarderUnderASine;
  const Hypothesis& best = search.tried[search.best];
  for (size_t i = 0; i < search.tried.size(); ++i) {
    const Hypothesis& other = search.tried[i];
    if (static_cast<int>(i) == search.best || other.suspects.size() != best.suspects.size()) {
      continue;
    }
    std::vector<int> shared, own;
    std::set_intersection(best.suspects.begin(),
                          best.suspects.end(),
                          other.suspects.begin(),
                          other.suspects.end(),
                          std::back_inserter(shared));
    if (shared.size() + 1 != best.suspects.size()) continue;
    std::set_difference(other.suspects.begin(),
                        other.suspects.end(),
                        shared.begin(),
                        shared.end(),
                        std::back_inserter(own));
    // What is no better than noise explains nothing.
    const Hypothesis* without = FindHypothesis(search, shared);
    if (without != nullptr &&
        search.significance.PValue(own.front(), other.gain - without->gain) > kExplainsNothing) {
      continue;
    }
    if (best.delta_bic - other.delta_bic < separation) rivals.push_back(static_cast<int>(i));
  }
  return rivals;
}

const Hypothesis* FindHypothesis(const SearchResult& search, const std::vector<int>& suspects) {
  for (const Hypothesis& hypothesis : search.tried) {
    if (hypothesis.suspects == suspects) return &hypothesis;
  }
  return nullptr;
}

const Hypothesis* FindWithout(const SearchResult& search, int index, int suspect) {
  std::vector<int> others = search.tried[index].suspects;
  std::erase(others, suspect);
  return FindHypothesis(search, others);
}

}  // namespace fathom
