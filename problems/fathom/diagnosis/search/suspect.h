// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/effect.h"
#include "fathom/vehicle/effect_law.h"

namespace fathom {

// What is tried: an effect with its partner, and the log that it acts in alone, if so.
struct Suspect {
  const Effect* effect = nullptr;
  EffectSetting setting;
};

}  // namespace fathom
