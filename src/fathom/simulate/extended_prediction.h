// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/log/log.h"
#include "fathom/signal/signals.h"
#include "fathom/simulate/effect_simulation.h"
#include "fathom/simulate/simulate.h"
#include "fathom/vehicle/extended_model.h"
#include "fathom/vehicle/fitted_model.h"

#include <optional>
#include <span>
#include <vector>

namespace fathom {

// As prediction.h, for a model with effects: what the velocity sensor shows in a free run.

// At `time` [s], from `initial`, which holds at its first stamp. Nothing if the simulation
// diverges.
std::optional<std::vector<double>> PredictReadings(const ExtendedModel& model,
                                                   const EffectInputs& inputs,
                                                   const std::vector<double>& time,
                                                   const InitialState& initial);

// The velocity at `time` at which the model's sensor shows `reading`: what it shows is affine in
// the velocity, so two probes tell. NaN if it shows the same at every velocity.
double VelocityBehind(const ExtendedModel& model,
                      const EffectInputs& inputs,
                      double time,
                      double reading);

// The state at `start` from which a model whose sensor has a memory
// (EffectSimulation::HasReadingMemory()) shows the first two seconds of `readings`, at `time`,
// best: least squares over the velocity and the excess of the reading, near `guess`, of which it
// keeps the position and what the water remembers. One reading tells the velocity of no such
// vehicle: the sensor still shows what was before. Nothing if the simulation diverges.
std::optional<InitialState> StateBehind(const ExtendedModel& model,
                                        const EffectInputs& inputs,
                                        double start,
                                        const std::vector<double>& time,
                                        const std::vector<double>& readings,
                                        const InitialState& guess);

// Where a free run over a measured segment starts: the InitialVelocity() behind its `reading`, or
// StateBehind() of its first readings. Nothing if there is none.
std::optional<InitialState> StartOf(const ExtendedModel& model,
                                    const EffectInputs& inputs,
                                    const Segment& segment,
                                    double reading,
                                    double position);

// The displacement along `dof` at `time` where the log has poses, in line between them; else 0.
double PositionAt(const Log& log, Dof dof, double time);

// MAE and NMAE of free runs over `segments`, each from its StartOf() about its InitialVelocity()
// and the position of the same index. NaN as FiguresOf() of the baseline.
FitFigures FiguresOf(const ExtendedModel& model,
                     const EffectInputs& inputs,
                     std::span<const Segment> segments,
                     std::span<const double> positions);

}  // namespace fathom
