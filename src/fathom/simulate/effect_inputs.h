// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/log/held_command.h"
#include "fathom/log/log.h"
#include "fathom/log/sampled_signal.h"
#include "fathom/signal/segment.h"
#include "fathom/vehicle/extended_model.h"

#include <array>
#include <string>
#include <vector>

namespace fathom {

// How finely a run is integrated.
struct StepRules {
  double longest = 0.2;   // [s]; what changes within a step is averaged
  double midpoint = 0.0;  // rate of the motion times step, below which the midpoint rule will do
};

// What a run with effects takes from a log, at the streams' own stamps.
struct EffectInputs {
  Dof dof = Dof::kSurge;                  // the one that is modelled
  HeldCommand command;                    // of it
  std::array<SampledSignal, 6> velocity;  // measured, by Index(Dof); empty where not
  std::array<HeldCommand, 6> force;       // commanded, by Index(Dof); empty where not
  StepRules steps = {};
  std::string log = {};  // as EffectSetting::log names it, where there are several
};

// A measured velocity as effects read it from a partner: smoothed by local polynomials over the
// window that predicts left-out samples best, since a model takes it as exact.
SampledSignal PartnerVelocity(const std::vector<double>& time, const std::vector<double>& measured);

// What effects along `dof` take from a log: every command, and every velocity of velocity.csv.
// Throws InputError if `dof` itself was not commanded.
EffectInputs MeasuredInputsOf(const Log& log, Dof dof);

// The same, with the poses' derivatives where velocity.csv has none.
EffectInputs EffectInputsOf(const Log& log, Dof dof);

// What a model without effects takes: the command of a segment.
EffectInputs CommandOnly(const Segment& segment);

// Throws InputError, saying which effect misses what, unless `inputs` hold what the effects of
// `model` need of their partners. `log` as messages name it.
void RequirePartners(const ExtendedModel& model, const EffectInputs& inputs, const Log& log);

}  // namespace fathom
