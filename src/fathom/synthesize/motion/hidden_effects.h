// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/vehicle/effect_stack.h"
#include "fathom/vehicle/extended_model.h"

#include <array>
#include <cstddef>
#include <span>

#include <Eigen/Core>

namespace fathom {

// The truth about all DOFs at one instant, from which an effect takes what it asks of its partner.
struct Surroundings {
  double time = 0.0;                            // since the first command sample [s]
  const Eigen::Matrix<double, 6, 1>& velocity;  // true [m/s] or [rad/s], by Index(Dof)
  const std::array<double, 6>& command;         // as logged at this time [N] or [N m]
};

// Everything that is hidden in one DOF, in the order in which it acts whatever the order of
// `effects`: docs/synthesize.md (10).
using HiddenEffects = EffectStack<double>;
HiddenEffects HiddenIn(Dof dof, std::span<const ActiveEffect> effects);

// What an effect is told of its surroundings.
Instant<double> InstantOf(const EffectSetting& setting, const Surroundings& now);

// The same for each of a stack, as its functions ask for it.
inline auto InstantsOf(const HiddenEffects& effects, const Surroundings& now) {
  return [&effects, &now](std::size_t k) { return InstantOf(effects[k].setting, now); };
}

}  // namespace fathom
