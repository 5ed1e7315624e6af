// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/coupled/coupled_effects.h"

#include "fathom/vehicle/effects/catalogue.h"

#include <algorithm>
#include <cstddef>

#include <ceres/jet.h>

namespace fathom {

std::span<const Effect* const> WaterEffects() {
  static const std::array<const Effect*, 3> effects = {
      FindEffect("damping_asymmetry"), FindEffect("cubic_damping"), FindEffect("coulomb_friction")};
  return effects;
}

std::span<const Effect* const> ThrustEffects() {
  static const std::array<const Effect*, 2> effects = {FindEffect("thrust_dead_zone"),
                                                       FindEffect("thrust_asymmetry")};
  return effects;
}

bool IsOfThrust(const Effect& effect) { return std::ranges::count(ThrustEffects(), &effect) > 0; }

EffectResistance ResistanceOf(const Effect& effect,
                              double value,
                              double speed,
                              double quadratic_damping) {
  WaterState<SmallJet> water;
  water.speed = water.relative_speed = SmallJet(speed, 0);
  water.quadratic_damping = SmallJet(quadratic_damping, 1);
  const SmallJet number(value, 2);
  const SmallJet force = effect.law<SmallJet>().resistance(&number, water, {});
  return {force.a, force.v[0], force.v[2], force.v[1]};
}

EffectiveThrust ThrustWith(const ThrustEffectValues& values, double force) {
  SmallJet left(force);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const SmallJet number(values[k], static_cast<int>(k));
    left = ThrustEffects()[k]->law<SmallJet>().thrust(&number, {}, left, {});
  }
  return {left.a, {left.v[0], left.v[1]}};
}

}  // namespace fathom
