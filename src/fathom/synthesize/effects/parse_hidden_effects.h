// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/synthesize/experiment/experiment.h"
#include "fathom/vehicle/extended_model.h"
#include "fathom/vehicle/scales.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace fathom {

// Reads a list of effects to hide, as it stands behind --effects:
//
//   thruster_lag:time_constant=0.5,heave.velocity_coupling:partner=yaw,unlisted.slack_tether
//
// Commas between effects; each may begin with the DOF it is hidden in, otherwise it is the first
// that the experiment drives; then its name, one of `effects`, and any of its parameters.
// Parameters that are not given are drawn from the seed (effect_sizes.h); a partner that is not
// given is the first other driven DOF that can be one. `scales` by Index(Dof), as ScalesOf().
//
// Throws InputError, saying what there is, for names and values that cannot be used.
std::vector<ActiveEffect> ParseHiddenEffects(const std::string& text,
                                             const Experiment& experiment,
                                             const std::array<Scales, 6>& scales,
                                             std::uint64_t seed,
                                             std::span<const Effect* const> effects);

// The same with EffectCatalogue() and UnlistedEffects().
std::vector<ActiveEffect> ParseHiddenEffects(const std::string& text,
                                             const Experiment& experiment,
                                             const std::array<Scales, 6>& scales,
                                             std::uint64_t seed);

// "surge.thruster_lag: time_constant = 0.5 s", with the partner if it has one.
std::string Describe(const ActiveEffect& effect);

}  // namespace fathom
