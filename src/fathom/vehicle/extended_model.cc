// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/extended_model.h"

#include "fathom/vehicle/effects/catalogue.h"

#include <algorithm>
#include <utility>

namespace fathom {
namespace {

// Where an effect acts: its place, then its turn in the catalogue.
std::pair<int, size_t> TurnOf(const Effect* effect) {
  const auto catalogue = EffectCatalogue();
  const auto found = std::find(catalogue.begin(), catalogue.end(), effect);
  return {static_cast<int>(effect->info().place), static_cast<size_t>(found - catalogue.begin())};
}

}  // namespace

ExtendedModel WithEffect(ExtendedModel model, ActiveEffect effect) {
  const auto turn = TurnOf(effect.effect);
  const auto place =
      std::find_if(model.effects.begin(), model.effects.end(), [&](const ActiveEffect& other) {
        return turn < TurnOf(other.effect);
      });
  model.effects.insert(place, std::move(effect));
  return model;
}

ExtendedModel WithoutEffect(ExtendedModel model, int index) {
  model.effects.erase(model.effects.begin() + index);
  return model;
}

}  // namespace fathom
