// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/effect.h"

#include <span>

namespace fathom {

// The effects between the force and the motion.
std::span<const Effect* const> WaterEffects();

}  // namespace fathom
