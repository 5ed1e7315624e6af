// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/log.h"
#include "fathom/vehicle/fitted_model.h"

#include <string>
#include <vector>

namespace fathom {

// A model as it holds for one log.
struct ModelForLog {
  FittedModel model;
  std::vector<std::string> left_out;  // effects, by LabelOf()
  bool is_trained_on_it = false;      // the model was identified from this log
};

// Leaves out the effects that belong to another run of the vehicle than the log's, as a current or
// a bias does (Scope::kRun), unless `keep_run_effects`. The log itself is known by its fingerprint.
ModelForLog RestrictToLog(FittedModel model, const Log& log, bool keep_run_effects);

}  // namespace fathom
