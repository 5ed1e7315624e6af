// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/effect.h"
#include "fathom/vehicle/effect_law.h"
#include "fathom/vehicle/uncoupled_model.h"

#include <vector>

namespace fathom {

// An effect at work, with its numbers.
struct ActiveEffect {
  const Effect* effect = nullptr;  // not owned
  EffectSetting setting;
  std::vector<double> values;  // in the order of effect->info().parameters
};

// The baseline model and any effects on top of it; no effects: the baseline.
struct ExtendedModel {
  UncoupledModel<double> baseline;
  std::vector<ActiveEffect> effects;  // in the order in which they act, that of EffectCatalogue()
};

// The model with one more effect, put where it acts: by EffectCatalogue()'s order; an effect from
// outside the catalogue comes last of its place.
ExtendedModel WithEffect(ExtendedModel model, ActiveEffect effect);

// The model without its effect `index`.
ExtendedModel WithoutEffect(ExtendedModel model, int index);

}  // namespace fathom
