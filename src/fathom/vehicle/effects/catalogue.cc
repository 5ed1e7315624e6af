// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/effects/catalogue.h"

#include "fathom/vehicle/effects/actuator_effects.h"
#include "fathom/vehicle/effects/sensor_effects.h"
#include "fathom/vehicle/effects/water_effects.h"

#include <algorithm>
#include <vector>

namespace fathom {

std::span<const Effect* const> EffectCatalogue() {
  static const std::vector<const Effect*> catalogue = [] {
    std::vector<const Effect*> all;
    for (const auto effects : {ActuatorEffects(), WaterEffects(), SensorEffects()}) {
      all.insert(all.end(), effects.begin(), effects.end());
    }
    return all;
  }();
  return catalogue;
}

const Effect* FindEffect(std::string_view name) {
  const auto catalogue = EffectCatalogue();
  const auto found = std::find_if(catalogue.begin(), catalogue.end(), [&](const Effect* effect) {
    return effect->info().name == name;
  });
  return found == catalogue.end() ? nullptr : *found;
}

}  // namespace fathom
