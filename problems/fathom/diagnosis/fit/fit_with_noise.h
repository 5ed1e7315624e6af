// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/fit/structure_fit.h"

#include <span>

namespace fathom {

// FitStructure() with the noise learned along: fit and noise in turns, from `noise`.
StructureFit FitStructureAndNoise(const TrainingData& data,
                                  const ExtendedModel& start,
                                  std::span<const InitialState> initial,
                                  const NoiseModel& noise);

// The same on from a fit whose residual and Jacobian are those of its model, the noise from that.
StructureFit FitStructureAndNoise(const TrainingData& data, const StructureFit& start);

// The baseline from a start near its optimum, with its noise.
StructureFit FitBaseline(const TrainingData& data,
                         const ExtendedModel& start,
                         std::span<const InitialState> initial);

// The noise of a fit's residual, of which nothing else is known.
NoiseModel FirstNoise(const TrainingData& data, const StructureFit& fit);

}  // namespace fathom
