// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/effect.h"

#include <array>
#include <span>

namespace fathom {

// The effects of the catalogue (docs/effects.md) that a CoupledModel may hold: of one number, 0
// where it is not there, without a memory, a partner or a time.

// Of the water along one DOF: damping_asymmetry, cubic_damping, coulomb_friction.
std::span<const Effect* const> WaterEffects();

// Of a force that is commanded, along one DOF or of each thruster: thrust_dead_zone,
// thrust_asymmetry; in the order in which they act.
std::span<const Effect* const> ThrustEffects();

// Whether an effect is one of ThrustEffects().
bool IsOfThrust(const Effect& effect);

// What an effect of the water resists with [N] or [N m], and its derivatives.
struct EffectResistance {
  double force = 0.0;
  double by_speed = 0.0;
  double by_value = 0.0;              // the effect's number
  double by_quadratic_damping = 0.0;  // that of the same DOF
};
EffectResistance ResistanceOf(const Effect& effect,
                              double value,
                              double speed,
                              double quadratic_damping);

// The numbers of ThrustEffects(), in their order.
using ThrustEffectValues = std::array<double, 2>;

// What is left of a commanded force [N] or [N m], and its derivatives by those numbers.
struct EffectiveThrust {
  double force = 0.0;
  ThrustEffectValues by_value = {};
};
EffectiveThrust ThrustWith(const ThrustEffectValues& values, double force);

}  // namespace fathom
