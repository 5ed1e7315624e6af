// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/fit/structure_fit.h"
#include "fathom/diagnosis/search/screen/calibration.h"

#include <map>
#include <set>
#include <vector>

namespace fathom {

// A set of suspects with the model that has them all.
struct Hypothesis {
  std::vector<int> suspects;  // indices, ascending; none: the baseline
  StructureFit fit;

  // 2 log-likelihood over the baseline's, less PriceOfStarts().
  double gain = 0.0;

  // BIC of the baseline less its own: above 0, better than the baseline.
  double delta_bic = 0.0;

  bool Has(int suspect) const;
};

// False where a cause presses on a bound of what is physical: the data ask for something else.
bool IsPhysical(const Hypothesis& hypothesis);

// Suspects less one of them.
std::vector<int> Without(std::vector<int> suspects, int suspect);

// What was tried and what came of it: one hypothesis for each set of suspects, the baseline first,
// then as they came.
class HypothesisBook {
 public:
  HypothesisBook(StructureFit baseline, Calibration calibration);

  const Calibration& calibration() const { return calibration_; }

  int size() const { return static_cast<int>(tried_.size()); }
  const Hypothesis& operator[](int index) const { return tried_[index]; }
  const Hypothesis& baseline() const { return tried_.front(); }

  // The hypothesis with exactly these suspects; -1 if there is none.
  int IndexOf(const std::vector<int>& suspects) const;

  // A hypothesis less one of its suspects; -1 if there is none.
  int IndexWithout(int index, int suspect) const;

  // Gain less what noise would reach with the same causes; minus infinity if it is not physical.
  double Worth(int index) const;

  // The one that stands for the data best so far: the baseline until a search says otherwise.
  int best() const { return best_; }
  void SetBest(int index) { best_ = index; }

  // The greatest gain of all; 0 where none gains.
  double MostGain() const;

  // Hypotheses of so many causes, the best first.
  std::vector<int> RankedOfSize(int size) const;

  // True if these suspects were refitted and no model that means something came of it.
  bool HasFailed(const std::vector<int>& suspects) const;

  // Writes a hypothesis down, unless its fit is not usable: one that stopped is ranked nowhere. Of
  // two of the same suspects the one that gains more is kept.
  void Add(Hypothesis hypothesis);

  // Takes a hypothesis of the same suspects in place of one.
  void Replace(int index, Hypothesis hypothesis) { tried_[index] = std::move(hypothesis); }

  // Writes down that these suspects were refitted, whatever comes of it.
  void AddAttempt(const std::vector<int>& suspects) { attempts_.insert(suspects); }

 private:
  Calibration calibration_;
  std::vector<Hypothesis> tried_;
  int best_ = 0;
  std::map<std::vector<int>, int> known_;  // index into tried_
  std::set<std::vector<int>> attempts_;
};

// Indices of hypotheses that explain the data as well as the best one, each with one of its
// suspects replaced: worse by less than `separation` (SeparationOn()).
std::vector<int> FindRivals(const HypothesisBook& book, int best, double separation);

// DiagnosisOptions::separation on these data. Under a single sine, causes that differ in phase
// alone are told apart by what little else there is: the start, the shape of the tops. That takes
// more than usual.
double SeparationOn(const TrainingData& data, double separation);

}  // namespace fathom
