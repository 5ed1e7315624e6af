// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <vector>

#include "hidden_log.h"

namespace fathom::hidden {

struct PlanSizes {
  int nothing = 120;
  int per_effect = 8;
  int two_effects = 40;
  int unlisted = 40;
};

// The logs of a set, in order: nothing, each effect, two effects, outside the catalogue.
std::vector<LogPlan> DrawPlans(const PlanSizes& sizes, std::uint64_t seed);

// Sizes `factor` times as large, none below 1.
PlanSizes Scaled(const PlanSizes& sizes, double factor);

}  // namespace fathom::hidden
