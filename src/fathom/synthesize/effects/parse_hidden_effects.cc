// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/effects/parse_hidden_effects.h"

#include "fathom/base/random_stream.h"
#include "fathom/synthesize/effects/given_effect.h"
#include "fathom/synthesize/effects/unlisted_effects.h"
#include "fathom/synthesize/motion/vehicle_motion.h"
#include "fathom/vehicle/effects/catalogue.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kNotDrawn = std::numeric_limits<double>::quiet_NaN();

// Values for an effect between just visible and large: even in their logarithm over the range of
// each parameter (EffectParameter::drawn; NaN without one), in units of the experiment's own
// scales; with a random sign where both are physical. `scales` by Index(Dof), as ScalesOf().
std::vector<double> DrawSizes(const Effect& effect,
                              Dof dof,
                              Dof partner,
                              const std::array<Scales, 6>& scales,
                              RandomStream& random) {
  const NaturalScales natural = {
      scales[Index(dof)], scales[Index(partner)], scales[Index(Dof::kYaw)]};
  std::vector<double> values;
  for (const EffectParameter& parameter : effect.info().parameters) {
    const SizeRange& range = parameter.drawn;
    const double size = range.smallest * std::pow(range.largest / range.smallest, random.Uniform());
    const double sign = random.Uniform() < 0.5 && range.either_sign ? -1.0 : 1.0;
    values.push_back(range.unit ? sign * size * range.unit(natural) : kNotDrawn);
  }
  return values;
}

// What is not given drawn.
ActiveEffect Drawn(const GivenEffect& given,
                   const std::array<Scales, 6>& scales,
                   std::uint64_t seed) {
  const EffectInfo& info = given.effect->info();
  const Dof dof = given.dof;
  ActiveEffect active;
  active.effect = given.effect;
  active.setting.dof = dof;
  if (info.has_partner()) active.setting.partner = given.partner;
  // A command of nothing but zeros has no size of its own.
  const double rms_force = scales[Index(dof)].force;
  if (rms_force > 0.0) active.setting.reference_force = rms_force;

  RandomStream random(seed, fmt::format("effect.{}.{}", Name(dof), info.name));
  active.values = DrawSizes(*active.effect, dof, active.setting.partner, scales, random);
  for (std::size_t i = 0; i < given.values.size(); ++i) {
    const EffectParameter& parameter = info.parameters[i];
    double& value = active.values[i];
    if (given.values[i]) value = *given.values[i];
    if (parameter.lower <= value && value <= parameter.upper && std::isfinite(value)) continue;
    FailEffects(
        fmt::format("{}.{}'s {} cannot be drawn: the experiment's command or motion is too small "
                    "to tell its size. Give it: {}=...",
                    Name(dof),
                    info.name,
                    parameter.name,
                    parameter.name));
  }
  return active;
}

}  // namespace

std::vector<ActiveEffect> ParseHiddenEffects(const std::string& text,
                                             const Experiment& experiment,
                                             const std::array<Scales, 6>& scales,
                                             std::uint64_t seed,
                                             std::span<const Effect* const> effects) {
  std::vector<ActiveEffect> hidden;
  if (text.empty()) return hidden;
  for (const std::string& part : Split(text, ',')) {
    hidden.push_back(Drawn(ParseGivenEffect(part, experiment, effects), scales, seed));
    const ActiveEffect& last = hidden.back();
    const auto is_same = [&](const ActiveEffect& other) {
      return other.effect == last.effect && other.setting.dof == last.setting.dof;
    };
    if (std::count_if(hidden.begin(), hidden.end(), is_same) > 1) {
      FailEffects(fmt::format("{}.{} is given twice, expected once.",
                              Name(last.setting.dof),
                              last.effect->info().name));
    }
  }
  if (hidden.size() > EffectStates::MaxRowsAtCompileTime) {
    FailEffects(fmt::format("holds {} effects, expected at most {}.",
                            hidden.size(),
                            int{EffectStates::MaxRowsAtCompileTime}));
  }
  return hidden;
}

std::vector<ActiveEffect> ParseHiddenEffects(const std::string& text,
                                             const Experiment& experiment,
                                             const std::array<Scales, 6>& scales,
                                             std::uint64_t seed) {
  std::vector<const Effect*> effects(EffectCatalogue().begin(), EffectCatalogue().end());
  effects.insert(effects.end(), UnlistedEffects().begin(), UnlistedEffects().end());
  return ParseHiddenEffects(text, experiment, scales, seed, effects);
}

std::string Describe(const ActiveEffect& active) {
  const EffectInfo& info = active.effect->info();
  const Dof dof = active.setting.dof;
  std::string text = fmt::format("{}.{}:", Name(dof), info.name);
  for (std::size_t i = 0; i < info.parameters.size(); ++i) {
    const std::string unit = UnitOf(info.parameters[i].quantity, dof, std::string(ForceUnit(dof)));
    text +=
        fmt::format("{} {} = {:.6g}", i == 0 ? "" : ",", info.parameters[i].name, active.values[i]);
    if (unit != "-") text += " " + unit;
  }
  if (info.has_partner()) text += fmt::format(", partner {}", Name(active.setting.partner));
  return text;
}

}  // namespace fathom
