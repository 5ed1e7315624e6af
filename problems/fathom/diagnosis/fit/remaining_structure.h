// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/fit/structure_fit.h"

#include <string_view>

namespace fathom {

// What a fitted model still leaves of the data that depends on its inputs, whatever the form.
struct RemainingStructure {
  static constexpr double kClear = 0.001;  // p-value below which it is said to remain

  double gain = 0.0;     // twice the log-likelihood that smooth forces of any form would gain
  int num_columns = 0;   // degrees of freedom they took; 0: they were not tried
  double p_value = 1.0;  // of that gain where nothing is left

  // Nothing was looked for: what is left is less than a sensor shows.
  bool is_negligible = false;
};

// Tries forces that are free, smooth functions of command, lagged command, speed, position and the
// product of command and speed, all at once, the noise learned along; and besides, a thrust that
// changes smoothly over the run, which is returned instead where it is clear and shows more. The
// p-value is that of two looks. Not tried on fewer than five samples per column, where they would
// take up the noise itself. Nothing here knows the catalogue; docs/diagnosis.md (8).
RemainingStructure FindRemainingStructure(const TrainingData& data, const StructureFit& fit);

// The same of one input at a time, of what the vehicle did or was told: the clearest. It sees a
// shape that is a little off, where all at once see none. The p-value is that of all these looks.
RemainingStructure FindRemainingOfOneInput(const TrainingData& data, const StructureFit& fit);

// A force that is a free, smooth function of one input.
struct FreeForm {
  std::string_view input;  // "displacement"; empty: none could be tried
  double gain = 0.0;       // twice the log-likelihood that it gains, less its degrees of freedom
};

// The one of greatest gain beside a fit, the noise learned along: of what the vehicle did or was
// told, not of time.
FreeForm BestFreeForm(const TrainingData& data, const StructureFit& fit);

}  // namespace fathom
