// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled/coupled_fit.h"
#include "fathom/coupled/folds.h"
#include "fathom/vehicle/coupled/coupled_model.h"
#include "fathom/vehicle/coupled/motion_structure.h"

#include <optional>
#include <vector>

namespace fathom {

// A structure fitted anew to the training part of each fold, from a fit of all data and with its
// noise; nothing of a fold whose search led nowhere. The folds share what they begin with: one step
// is nearly always enough.
std::vector<std::optional<CoupledModel>> FitFolds(const std::vector<Fold>& folds,
                                                  const MotionStructure& structure,
                                                  const CoupledSummary& fit,
                                                  const CoupledFitOptions& options);

}  // namespace fathom
