// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/simulate/coupled/coupled_data.h"
#include "fathom/simulate/free_run.h"
#include "fathom/vehicle/coupled/coupled_model.h"
#include "fathom/vehicle/fitted_model.h"

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace fathom {

// What a model of several DOFs predicts for logs.
struct CoupledPrediction {
  // Of each segment of each log, at its stamps: the modelled velocities, the others as measured.
  std::vector<std::vector<std::vector<Vector6>>> velocity;

  // By Index(Dof), of modelled DOFs; docs/models.md (7) and (8).
  std::array<FitFigures, 6> figures, train, held_out;

  // Root mean square of how far from the measured position the simulated one is, 10 s after a
  // start from the measured state [m]. NaN without positions, and for shorter horizons.
  double position_error = std::numeric_limits<double>::quiet_NaN();
};

// Free runs of `model` over its command, each begun anew from the measured state after `horizon`
// [s], above 0; infinite: once for each segment. Nothing if a run diverges.
std::optional<CoupledPrediction> PredictCoupled(const CoupledModel& model,
                                                std::span<const CoupledData> logs,
                                                double horizon);

// Samples of a segment along one DOF, beside what was predicted for them, those without a
// measurement left out. `predicted`: of these samples.
FreeRun FreeRunAlong(Dof dof,
                     const CoupledSegment& segment,
                     const SampleWindow& samples,
                     std::span<const Vector6> predicted);

// The same of all segments of all logs that a prediction is of.
std::vector<FreeRun> FreeRunsAlong(Dof dof,
                                   std::span<const CoupledData> logs,
                                   const CoupledPrediction& prediction);

}  // namespace fathom
