// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/planning/experiment_plan.h"
#include "fathom/report/page.h"

#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// A planned force, each held until the next stamp.
TimePanel CommandPanel(Dof dof, const std::vector<double>& time, const std::vector<double>& force);

// What the vehicle will do, with the limits that there are.
TimePanel MotionPanel(const std::string& quantity,
                      std::string_view unit,
                      const std::vector<double>& time,
                      const PlannedBand& band,
                      const ValueRange& limits);

}  // namespace fathom
