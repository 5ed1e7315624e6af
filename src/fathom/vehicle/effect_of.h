// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/effect.h"

namespace fathom {

// Makes an Effect of a struct E that has
//
//   static EffectInfo Info();
//   template <typename T> static EffectLaw<T> Law();
//
// docs/adding_an_effect.md shows one. The source file that uses this includes <ceres/jet.h> and
// sees the whole of E.
template <typename E>
Effect EffectOf() {
  return {E::Info(),
          {E::template Law<double>(), E::template Law<SmallJet>(), E::template Law<LargeJet>()}};
}

}  // namespace fathom
