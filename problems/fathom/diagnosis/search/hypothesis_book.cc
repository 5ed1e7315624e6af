// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/search/hypothesis_book.h"

#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace fathom {
namespace {

constexpr double kExplainsNothing = 0.05;  // p-value of a rival alone
constexpr double kHarderUnderASine = 10.0;

// The suspects of one that are those of another too, and the others.
struct Overlap {
  std::vector<int> shared, own;
};

Overlap OverlapOf(const Hypothesis& one, const Hypothesis& other) {
  Overlap overlap;
  const auto &a = one.suspects, &b = other.suspects;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(overlap.shared));
  std::set_difference(a.begin(),
                      a.end(),
                      overlap.shared.begin(),
                      overlap.shared.end(),
                      std::back_inserter(overlap.own));
  return overlap;
}

}  // namespace

bool Hypothesis::Has(int suspect) const {
  return std::count(suspects.begin(), suspects.end(), suspect) > 0;
}

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

std::vector<int> Without(std::vector<int> suspects, int suspect) {
  std::erase(suspects, suspect);
  return suspects;
}

HypothesisBook::HypothesisBook(StructureFit baseline, Calibration calibration)
    : calibration_(std::move(calibration)) {
  known_[{}] = 0;
  tried_.push_back({{}, std::move(baseline), 0.0, 0.0});  // usable or not: it is what there is
}

int HypothesisBook::IndexOf(const std::vector<int>& suspects) const {
  const auto found = known_.find(suspects);
  return found == known_.end() ? -1 : found->second;
}

int HypothesisBook::IndexWithout(int index, int suspect) const {
  return IndexOf(Without(tried_[index].suspects, suspect));
}

double HypothesisBook::Worth(int index) const {
  const Hypothesis& hypothesis = tried_[index];
  if (!IsPhysical(hypothesis)) return -std::numeric_limits<double>::infinity();
  return hypothesis.gain - calibration_.ThresholdOf(hypothesis.suspects);
}

double HypothesisBook::MostGain() const {
  double most = 0.0;
  for (const Hypothesis& hypothesis : tried_) most = std::max(most, hypothesis.gain);
  return most;
}

std::vector<int> HypothesisBook::RankedOfSize(int size) const {
  std::vector<int> ranked;
  for (int i = 0; i < this->size(); ++i) {
    if (static_cast<int>(tried_[i].suspects.size()) == size) ranked.push_back(i);
  }
  std::stable_sort(ranked.begin(), ranked.end(), [&](int a, int b) { return Worth(a) > Worth(b); });
  return ranked;
}

bool HypothesisBook::HasFailed(const std::vector<int>& suspects) const {
  return attempts_.contains(suspects) && IndexOf(suspects) < 0;
}

void HypothesisBook::Add(Hypothesis hypothesis) {
  if (!hypothesis.fit.IsUsable()) return;
  const int index = IndexOf(hypothesis.suspects);
  if (index < 0) {
    known_[hypothesis.suspects] = size();
    tried_.push_back(std::move(hypothesis));
  } else if (hypothesis.gain > tried_[index].gain) {
    tried_[index] = std::move(hypothesis);
  }
}

std::vector<int> FindRivals(const HypothesisBook& book, int best, double separation) {
  std::vector<int> rivals;
  if (best == 0) return rivals;
  for (int i = 0; i < book.size(); ++i) {
    if (i == best || book[i].suspects.size() != book[best].suspects.size()) continue;
    const Overlap overlap = OverlapOf(book[i], book[best]);
    if (overlap.own.size() != 1) continue;
    // What is no better than noise explains nothing.
    const int without = book.IndexOf(overlap.shared);
    if (without >= 0 &&
        book.calibration().significance.PValue(
            overlap.own.front(), book[i].gain - book[without].gain) > kExplainsNothing) {
      continue;
    }
    if (book[best].delta_bic - book[i].delta_bic < separation) rivals.push_back(i);
  }
  return rivals;
}

double SeparationOn(const TrainingData& data, double separation) {
  return data.command_tone().IsAlone() ? separation * kHarderUnderASine : separation;
}

}  // namespace fathom
