// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/log/log.h"
#include "fathom/simulate/effect_simulation.h"
#include "fathom/vehicle/extended_model.h"

namespace fathom {

// A measured velocity as effects read it from a partner: smoothed by local polynomials over the
// window that predicts left-out samples best, since a model takes it as exact.
SampledSignal PartnerVelocity(const std::vector<double>& time, const std::vector<double>& measured);

// What effects along `dof` take from a log: every command, and every velocity of velocity.csv.
// Throws InputError if `dof` itself was not commanded.
EffectInputs MeasuredInputsOf(const Log& log, Dof dof);

// The same, with the poses' derivatives where velocity.csv has none.
EffectInputs EffectInputsOf(const Log& log, Dof dof);

// Which of a partner's measurements an effect really uses, found by asking its equation.
struct PartnerNeeds {
  bool velocity = false;
  bool yaw_rate = false;
  bool force = false;
};
PartnerNeeds NeedsOf(const ActiveEffect& effect);

// Throws InputError, saying which effect misses what, unless `inputs` hold what the effects of
// `model` need of their partners. `log` as messages name it.
void RequirePartners(const ExtendedModel& model, const EffectInputs& inputs, const Log& log);

}  // namespace fathom
