// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/report/page.h"
#include "fathom/simulate/coupled/coupled_data.h"
#include "fathom/simulate/coupled/coupled_prediction.h"

#include <span>
#include <string>
#include <vector>

namespace fathom {

// Free runs of a model over some logs, and what a page calls it.
struct NamedPrediction {
  std::string name;
  const CoupledPrediction* prediction;  // of the same logs, which outlives this
};

// One panel for each DOF and each log: the measured velocity and the free runs.
std::vector<TimePanel> MotionPanels(std::span<const CoupledData> logs,
                                    const std::vector<Dof>& dofs,
                                    std::span<const NamedPrediction> predictions);

}  // namespace fathom
