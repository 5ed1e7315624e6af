// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/motion/hidden_effects.h"

#include "fathom/vehicle/effects/catalogue.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <glog/logging.h>

namespace fathom {

HiddenEffects HiddenIn(Dof dof, std::span<const ActiveEffect> effects) {
  std::vector<const ActiveEffect*> hidden;
  for (const ActiveEffect& active : effects) {
    if (active.setting.dof == dof) hidden.push_back(&active);
  }
  std::stable_sort(hidden.begin(), hidden.end(), [](const auto* a, const auto* b) {
    return ActsBefore(a->effect, b->effect);
  });
  std::vector<StackedEffect<double>> stacked;
  for (const ActiveEffect* active : hidden) {
    CHECK(active->effect != nullptr);
    const EffectInfo& info = active->effect->info();
    CHECK_EQ(active->values.size(), info.parameters.size()) << info.name;
    stacked.push_back(
        {&active->effect->law<double>(), active->setting, info.has_partner(), active->values});
  }
  return HiddenEffects(std::move(stacked));
}

Instant<double> InstantOf(const EffectSetting& setting, const Surroundings& now) {
  const int partner = Index(setting.partner);
  return {now.time, {now.velocity[partner], now.velocity[Index(Dof::kYaw)], now.command[partner]}};
}

}  // namespace fathom
