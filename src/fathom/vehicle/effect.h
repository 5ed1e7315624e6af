// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/effect_info.h"
#include "fathom/vehicle/effect_law.h"

#include <tuple>
#include <utility>

namespace fathom {

// An effect of the catalogue, or a user's own: EffectOf<Struct>() (effect_of.h) makes one from a
// struct that states its equation once, for plain and differentiated scalars.
// docs/adding_an_effect.md. Models point at effects: two effects are the same if their addresses
// are.
class Effect {
 public:
  using Laws = std::tuple<EffectLaw<double>, EffectLaw<SmallJet>, EffectLaw<LargeJet>>;

  Effect(EffectInfo info, const Laws& laws) : info_(std::move(info)), laws_(laws) {}

  const EffectInfo& info() const { return info_; }

  // The equation in one of the scalars that a simulation runs in.
  template <typename T>
  const EffectLaw<T>& law() const {
    return std::get<EffectLaw<T>>(laws_);
  }

 private:
  EffectInfo info_;
  Laws laws_;
};

}  // namespace fathom
