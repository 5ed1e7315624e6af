// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/log/log.h"
#include "fathom/signal/signals.h"
#include "fathom/simulate/effect_inputs.h"
#include "fathom/simulate/simulate.h"
#include "fathom/vehicle/extended_model.h"

#include <optional>
#include <vector>

namespace fathom {

// Where a free run starts, from what was measured.

// What a segment shows at first: its initial_velocity, or where that is not known its first
// measured velocity.
double InitialVelocity(const Segment& segment);

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

// Where a free run over a measured segment starts: the velocity behind its first `reading`, or
// StateBehind() of its first readings; without effects the reading itself, and `inputs` may be
// null. Nothing if there is none.
std::optional<InitialState> StartOf(const ExtendedModel& model,
                                    const Segment& segment,
                                    double reading,
                                    double position = 0.0,
                                    const EffectInputs* inputs = nullptr);

// The displacement along `dof` at `time` where the log has poses, in line between them; else 0.
double PositionAt(const Log& log, Dof dof, double time);

}  // namespace fathom
