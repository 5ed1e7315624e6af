// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/comparison/comparison.h"
#include "fathom/report/panel.h"

#include <vector>

namespace fathom {

// The paper's Fig. 5 for one DOF: what was measured against each usable model's free run, over the
// whole log, in seconds since its first sample. All models but the recommended one are faded.
TimePanel ResponsePanel(const DofComparison& comparison);

// The command over the same time.
TimePanel CommandPanel(const DofComparison& comparison);

// One small plot per parameter: each usable model's value with its interval.
std::vector<ParameterPanel> ParameterPanels(const DofComparison& comparison);

}  // namespace fathom
