// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/planning/plan_request.h"
#include "fathom/planning/rival_separation.h"

#include <cstddef>
#include <optional>

namespace fathom {

// The request led by another of its rivals than the verdict's own: limits and parameters are then
// those of this one. Its covariance is that which `log`, the stand-in for the log, would give.
// Nothing if that leaves a parameter open.
std::optional<PlanRequest> LedByRival(PlanRequest request,
                                      std::size_t index,
                                      const RunSetting& log);

}  // namespace fathom
