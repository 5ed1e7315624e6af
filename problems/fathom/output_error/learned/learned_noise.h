// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/noise/fit_noise.h"
#include "fathom/output_error/learned/binned_run.h"
#include "fathom/output_error/learned/binned_segment.h"
#include "fathom/output_error/offset_sharing.h"

#include <optional>
#include <span>

namespace fathom {

// The noise of the residuals that free runs of `model` leave, whose start and parameters were
// fitted to the same data: sensor noise and a disturbance of the vehicle, docs/residual_noise.md.
// `runs` by segment, not whitened. `start`: as in FitNoiseOptions.
NoiseFit LearnNoise(std::span<const BinnedSegment> bins,
                    std::span<const BinnedRun> runs,
                    const UncoupledModel<double>& model,
                    const OffsetSharing& offsets,
                    const std::optional<NoiseModel>& start);

// Fills the damping factors of all bins, for a vehicle that is about `model`.
void SetDampingFactors(const UncoupledModel<double>& model, std::span<BinnedSegment> bins);

}  // namespace fathom
