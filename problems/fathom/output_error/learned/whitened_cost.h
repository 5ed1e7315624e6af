// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/noise/whitener.h"
#include "fathom/output_error/learned/binned_segment.h"

#include <memory>

namespace ceres {
class CostFunction;
}

namespace fathom {

// The residuals of one segment's free run over its bins, whitened by a learned noise: W times
// (simulated - measured), docs/output_error.md (10). Both arguments must outlive the result.
//
// Parameter blocks as those of MakeWindowCost(): the VehicleBlock, the buoyancy, the segment's
// initial state. Evaluation fails (returns false) where the simulation
// diverges.
std::unique_ptr<ceres::CostFunction> MakeWhitenedCost(const BinnedSegment& bins,
                                                      const Whitener& whitener);

}  // namespace fathom
