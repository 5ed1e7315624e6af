// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/fit/structure_fit.h"

#include <span>

namespace fathom {

// Of the error of a free run: a step that promises less is none where a fit only ranks or predicts,
// since what they decide is 5 % of an error.
inline constexpr double kRoughShareOfFreeRun = 1e-3;

// FitStructure() on from a fit whose residual and Jacobian are those of its model, its noise
// learned in turns with it, from the likeliest of those known of other models, one at least.
StructureFit FitBy(Criterion criterion,
                   const TrainingData& data,
                   const StructureFit& start,
                   std::span<const NoiseModel> known,
                   const FitPrecision& precision = {});

// The same from a model that was not run yet.
StructureFit FitBy(Criterion criterion,
                   const TrainingData& data,
                   const ExtendedModel& start,
                   std::span<const InitialState> initial,
                   const NoiseModel& noise,
                   const FitPrecision& precision = {});

// FitStructure() with the noise learned along: fit and noise in turns, from `noise`.
StructureFit FitStructureAndNoise(const TrainingData& data,
                                  const ExtendedModel& start,
                                  std::span<const InitialState> initial,
                                  const NoiseModel& noise,
                                  const FitPrecision& precision = {});

// The same on from a fit whose residual and Jacobian are those of its model, the noise from that.
StructureFit FitStructureAndNoise(const TrainingData& data,
                                  const StructureFit& start,
                                  const FitPrecision& precision = {});

// The baseline from a start near its optimum, with its noise.
StructureFit FitBaseline(const TrainingData& data,
                         const ExtendedModel& start,
                         std::span<const InitialState> initial);

// The noise of a fit's residual, of which nothing else is known.
NoiseModel FirstNoise(const TrainingData& data, const StructureFit& fit);

}  // namespace fathom
