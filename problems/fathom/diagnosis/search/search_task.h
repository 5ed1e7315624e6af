// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/data/training_data.h"
#include "fathom/diagnosis/options.h"
#include "fathom/diagnosis/search/search_options.h"
#include "fathom/diagnosis/search/suspect.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace fathom {

// What a search is over, and how: the same in all its steps. Suspects go by their index in it.
struct SearchTask {
  const TrainingData& data;
  const std::vector<Suspect>& suspects;
  const DiagnosisOptions& wanted;
  SearchOptions options;

  // TrainingData::work() when the search for one cause more began.
  std::int64_t begun = 0;

  // Whether that search has to end.
  bool IsSpent() const {
    constexpr double kUsual = 300.0;  // [s]
    const double length = std::max(1.0, std::sqrt(data.duration() / kUsual));
    return static_cast<double>(data.work() - begun) > wanted.effort * options.most_work * length;
  }

  int num_suspects() const { return static_cast<int>(suspects.size()); }
};

// Place of a suspect's effect in a model that has it.
int EffectPlace(const SearchTask& task, const ExtendedModel& model, int suspect);

}  // namespace fathom
