// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/effect.h"
#include "fathom/vehicle/uncoupled_model.h"

#include <cstddef>
#include <string>
#include <vector>

namespace fathom {

// An effect at work, with its numbers.
struct ActiveEffect {
  const Effect* effect = nullptr;  // not owned
  EffectSetting setting;
  std::vector<double> values;  // in the order of effect->info().parameters
};

// An effect as people and files tell it from others of its kind: "thruster_lag",
// "velocity_coupling(sway)", "buoyancy_step(dive_2)" where it acts in one of several logs alone.
std::string LabelOf(const EffectInfo& info, const EffectSetting& setting);

// The most effects that a simulation takes.
inline constexpr std::size_t kMostEffects = 6;

// The baseline model and any effects on top of it; no effects: the baseline.
struct ExtendedModel {
  UncoupledModel<double> baseline;
  // In the order in which they act, that of EffectCatalogue().
  std::vector<ActiveEffect> effects = {};
};

// What is wrong with a list of effects of a model, after "'effects' "; empty if nothing: "lists
// thruster_lag twice".
std::string ProblemWith(const std::vector<ActiveEffect>& effects);

// The model with one more effect, put where it acts: by EffectCatalogue()'s order; an effect from
// outside the catalogue comes last of its place.
ExtendedModel WithEffect(ExtendedModel model, ActiveEffect effect);

// The model without its effect `index`.
ExtendedModel WithoutEffect(ExtendedModel model, int index);

}  // namespace fathom
