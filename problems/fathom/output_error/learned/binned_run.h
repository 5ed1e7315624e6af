// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/noise/whitener.h"
#include "fathom/output_error/learned/binned_segment.h"
#include "fathom/output_error/reduced_normal.h"
#include "fathom/simulate/simulate.h"
#include "fathom/vehicle/uncoupled_model.h"

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// A free run over one segment and its derivatives, averaged over its bins: a row for each. Columns:
// the parameters, a time offset of the command, the initial velocity and position, and the residual
// (simulated - measured), side by side to be whitened in one go.
struct BinnedRun {
  static constexpr int kNumColumns = kSharedColumns + 3;
  RowMajorMatrix columns;
  FittedOutput output = FittedOutput::kVelocity;

  // Derivatives of the output; the initial position's only where it is the output.
  auto J() const { return columns.leftCols(kSharedColumns + StateSize(output)); }
  auto parameters() const { return columns.leftCols(kNumParameters); }
  auto state() const { return columns.middleCols(kSharedColumns, StateSize(output)); }
  auto residual() const { return columns.col(kNumColumns - 1); }
};

// Nothing if the simulation diverges.
std::optional<BinnedRun> RunOverBins(const UncoupledModel<double>& model,
                                     const InitialState& initial,
                                     const BinnedSegment& bins);

// The residual sample by sample, simulated - measured [unit of the output]; empty if the simulation
// diverges.
std::vector<double> RunOverSamples(const UncoupledModel<double>& model,
                                   const InitialState& initial,
                                   const Segment& segment,
                                   FittedOutput output);

}  // namespace fathom
