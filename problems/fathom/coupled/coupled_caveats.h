// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled/coupled_summary.h"
#include "fathom/coupled/identification_task.h"
#include "fathom/simulate/coupled/coupled_prediction.h"
#include "fathom/vehicle/coupled/fitted_coupled_model.h"

#include <span>
#include <string>
#include <vector>

namespace fathom {

// What to know of a model before it is used.
std::vector<std::string> CaveatsOnModel(const FittedCoupledModel& fitted,
                                        const CoupledSummary& fit,
                                        const IdentificationTask& task);

// The same of this fit alone, which a refinement may mend. `prediction`: free runs over the logs.
std::vector<std::string> CaveatsOnFit(const FittedCoupledModel& fitted,
                                      const CoupledSummary& fit,
                                      std::span<const CoupledData> logs,
                                      const CoupledPrediction& prediction);

}  // namespace fathom
