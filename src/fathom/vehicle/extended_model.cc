// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/extended_model.h"

#include "fathom/vehicle/effects/catalogue.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace fathom {

std::string LabelOf(const EffectInfo& info, const EffectSetting& setting) {
  std::string within = info.has_partner() ? std::string(Name(setting.partner)) : "";
  if (!setting.log.empty()) within += (within.empty() ? "" : ", ") + setting.log;
  return within.empty() ? std::string(info.name) : fmt::format("{}({})", info.name, within);
}

std::string ProblemWith(const std::vector<ActiveEffect>& effects) {
  if (effects.size() > kMostEffects) {
    return fmt::format("lists {} effects, expected at most {}", effects.size(), kMostEffects);
  }
  for (std::size_t i = 0; i < effects.size(); ++i) {
    const std::string label = LabelOf(effects[i].effect->info(), effects[i].setting);
    for (std::size_t j = 0; j < i; ++j) {
      const std::string before = LabelOf(effects[j].effect->info(), effects[j].setting);
      if (label == before) return fmt::format("lists {} twice", label);
      if (!ActsBefore(effects[i].effect, effects[j].effect)) continue;
      return fmt::format(
          "lists {} before {}, expected the order in which they act: the other way round",
          before,
          label);
    }
  }
  return "";
}

ExtendedModel WithEffect(ExtendedModel model, ActiveEffect effect) {
  const auto place =
      std::find_if(model.effects.begin(), model.effects.end(), [&](const ActiveEffect& other) {
        return ActsBefore(effect.effect, other.effect);
      });
  model.effects.insert(place, std::move(effect));
  return model;
}

ExtendedModel WithoutEffect(ExtendedModel model, int index) {
  model.effects.erase(model.effects.begin() + index);
  return model;
}

}  // namespace fathom
