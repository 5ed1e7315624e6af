// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/effect_of.h"
#include "fathom/vehicle/effects/bounds.h"
#include "fathom/vehicle/effects/natural_units.h"

#include <cmath>

#include <ceres/jet.h>

namespace fathom {

// An effect of a user's own, as docs/adding_an_effect.md shows it.
struct SquareRootDrag {
  static EffectInfo Info() {
    return {.name = "square_root_drag",
            .place = Place::kWater,
            .scope = Scope::kVehicle,
            .parameters = {{.name = "coefficient",
                            .quantity = {"N s/m", "N m s/rad", 1, -1, 0},
                            .null = 0.0,
                            .lower = 0.0,
                            .upper = kInfinity,
                            .drawn = {0.1, 1.0, natural::LinearDrag}}},
            .cause = "a drag that grows with the root of the speed",
            .advice = "Keep it."};
  }
  template <typename T>
  static EffectLaw<T> Law() {
    return {.resistance = [](const T* p, const WaterState<T>& water, const Instant<T>&) {
      using std::sqrt;
      const T size = sqrt(water.speed * water.speed + 1e-4);
      return p[0] * water.speed / sqrt(size);
    }};
  }
};

}  // namespace fathom
