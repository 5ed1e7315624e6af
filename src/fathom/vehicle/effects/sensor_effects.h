// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/effect.h"

#include <span>

namespace fathom {

// The effects between the motion and what is measured of it, in the order in which they act.
std::span<const Effect* const> SensorEffects();

}  // namespace fathom
