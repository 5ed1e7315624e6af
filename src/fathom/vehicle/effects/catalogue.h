// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/effect.h"

#include <span>
#include <string_view>

namespace fathom {

// Every effect that Fathom knows, in the order in which they act: actuator, water, sensor.
std::span<const Effect* const> EffectCatalogue();

// Null if the catalogue holds no effect of this name.
const Effect* FindEffect(std::string_view name);

// Whether `a` acts before `b`: in an earlier place, or earlier in the catalogue. An effect from
// outside the catalogue comes last of its place.
bool ActsBefore(const Effect* a, const Effect* b);

}  // namespace fathom
