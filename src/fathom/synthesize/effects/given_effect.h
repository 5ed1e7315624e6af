// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/synthesize/experiment/experiment.h"
#include "fathom/vehicle/effect.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fathom {

// One effect of a list, as far as it is given: "heave.velocity_coupling:partner=yaw".
struct GivenEffect {
  const Effect* effect = nullptr;
  Dof dof = Dof::kSurge;
  Dof partner = Dof::kYaw;                    // where one takes part
  std::vector<std::optional<double>> values;  // in the order of its parameters
};

// Without a DOF: the first that the experiment drives. Without a partner: the first other driven
// DOF that can be one. Throws InputError, saying what there is, for names and values that cannot be
// used.
GivenEffect ParseGivenEffect(const std::string& text,
                             const Experiment& experiment,
                             std::span<const Effect* const> effects);

// Throws InputError for the list of effects.
[[noreturn]] void FailEffects(const std::string& message);

// The parts of a text between separators, at least one.
std::vector<std::string> Split(const std::string& text, char separator);

}  // namespace fathom
