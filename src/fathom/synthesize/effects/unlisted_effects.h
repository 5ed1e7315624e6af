// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/effect.h"

#include <span>
#include <string_view>

namespace fathom {

// Physical effects that are left out of EffectCatalogue() on purpose: hidden in a log, they show
// whether a diagnosis says that it cannot name them. Their names begin with "unlisted.";
// docs/synthesize.md has their equations.
std::span<const Effect* const> UnlistedEffects();

// Null if there is none of this name.
const Effect* FindUnlistedEffect(std::string_view name);

}  // namespace fathom
