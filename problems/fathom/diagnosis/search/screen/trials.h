// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/fit/structure_fit.h"
#include "fathom/diagnosis/search/screen/trial.h"
#include "fathom/diagnosis/search/suspect.h"

#include <vector>

namespace fathom {

// Every suspect at every trial about one fitted model.
struct Trials {
  std::vector<Trial> trials;
  RowMajorMatrix signatures;  // rows: bins
};

Trials TrialsAbout(const TrainingData& data,
                   const StructureFit& fit,
                   const std::vector<Suspect>& suspects);

// The trial's suspect at times of the run between this trial's and its neighbours'; none if it has
// no such time.
Trials TrialsNear(const TrainingData& data,
                  const StructureFit& fit,
                  const std::vector<Suspect>& suspects,
                  const Trial& trial);

// True if the effect has a frequency of the run and it is that of a single tone which the command
// is: then it cannot be told from an answer that comes early or late, and nothing is to be said
// of it.
bool IsAtTheCommandsTone(const TrainingData& data,
                         const EffectInfo& info,
                         const std::vector<double>& values);

}  // namespace fathom
