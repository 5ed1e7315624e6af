// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/simulate/log_prediction.h"
#include "fathom/vehicle/fitted_model.h"

#include <string>
#include <vector>

namespace fathom {

// What to know before a prediction is believed, a sentence each: that the model missed much of the
// motion that it was fitted to (where it has caveats these say so), or misses much of this log's
// (kPoorFit), and that this log leaves the speeds or the forces that it was fitted to. A log leaves
// them where it goes beyond by more than a tenth of their range: less is noise.
std::vector<std::string> RemarksOn(const FittedModel& model, const LogPrediction& prediction);

}  // namespace fathom
