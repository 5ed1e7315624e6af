// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/search/screen/screens.h"
#include "fathom/diagnosis/search/screen/significance.h"

#include <vector>

namespace fathom {

// How much a suspect must gain before it is worth a word.
struct Calibration {
  Significance significance;

  // By suspect: what it must gain alone, and beside other causes. More than noise reaches, and more
  // than BIC asks for its parameters.
  std::vector<double> thresholds, thresholds_beside;

  // What a set of suspects must gain over the baseline.
  double ThresholdOf(const std::vector<int>& suspects) const;
};

// From the baseline's own screen; nothing is ever significant where there is none.
Calibration CalibrationOf(const SearchTask& task, const Screens& about_baseline);

}  // namespace fathom
