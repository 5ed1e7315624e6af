// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/effects/effect_list.h"

#include "fathom/base/input_error.h"
#include "fathom/base/number.h"
#include "fathom/base/quoted.h"
#include "fathom/synthesize/effects/effect_sizes.h"
#include "fathom/synthesize/effects/unlisted_effects.h"
#include "fathom/synthesize/motion/vehicle_motion.h"
#include "fathom/vehicle/effects/catalogue.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

[[noreturn]] void Fail(const std::string& message) { throw InputError("--effects: " + message); }

std::vector<std::string> Split(const std::string& text, char separator) {
  std::vector<std::string> parts = {""};
  for (const char c : text) {
    if (c == separator) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

std::string DrivenNames(const Experiment& experiment) {
  std::vector<std::string_view> names;
  for (const Drive& drive : experiment.drives) names.push_back(Name(drive.dof));
  return fmt::format("{}", fmt::join(names, ", "));
}

bool IsDriven(const Experiment& experiment, Dof dof) {
  return std::any_of(experiment.drives.begin(), experiment.drives.end(), [&](const Drive& drive) {
    return drive.dof == dof;
  });
}

Dof DrivenDof(const std::string& name, const Experiment& experiment) {
  const std::optional<Dof> dof = DofFromName(name);
  if (dof && IsDriven(experiment, *dof)) return *dof;
  Fail(fmt::format("{} is not a DOF that the experiment drives, expected one of {}.",
                   Quoted(name),
                   DrivenNames(experiment)));
}

const Effect* EffectOfName(const std::string& name) {
  if (const Effect* effect = FindEffect(name)) return effect;
  if (const Effect* effect = FindUnlistedEffect(name)) return effect;
  std::vector<std::string_view> names;
  for (const Effect* effect : EffectCatalogue()) names.push_back(effect->info().name);
  for (const Effect* effect : UnlistedEffects()) names.push_back(effect->info().name);
  Fail(fmt::format("{} is no effect, expected one of {}.", Quoted(name), fmt::join(names, ", ")));
}

// A lever arm's partner is a rotation about another axis; Coriolis wants a velocity beside yaw's.
bool CanBePartner(const EffectInfo& info, Dof dof, Dof partner) {
  if (partner == dof) return false;
  if (info.name == "lever_arm") {
    return !IsAngular(dof) && IsAngular(partner) && Index(partner) != Index(dof) + 3;
  }
  if (info.name == "coriolis_coupling") return partner != Dof::kYaw;
  if (info.name == "sensor_misalignment") return IsAngular(partner) == IsAngular(dof);
  return true;
}

std::string PartnerNames(const EffectInfo& info, Dof dof, const Experiment& experiment) {
  std::vector<std::string_view> names;
  for (const Drive& drive : experiment.drives) {
    if (CanBePartner(info, dof, drive.dof)) names.push_back(Name(drive.dof));
  }
  if (!names.empty()) return fmt::format("{}", fmt::join(names, ", "));
  return "an experiment that drives one";
}

Dof FirstPartner(const EffectInfo& info, Dof dof, const Experiment& experiment) {
  for (const Drive& drive : experiment.drives) {
    if (CanBePartner(info, dof, drive.dof)) return drive.dof;
  }
  Fail(fmt::format("{}.{} needs another DOF that takes part, expected {}.",
                   Name(dof),
                   info.name,
                   PartnerNames(info, dof, experiment)));
}

// "a number from 0 to 20", "a finite number of at least 0".
std::string ValuesOf(const EffectParameter& parameter) {
  const bool has_lower = std::isfinite(parameter.lower), has_upper = std::isfinite(parameter.upper);
  if (has_lower && has_upper) {
    return fmt::format("a number from {} to {}", parameter.lower, parameter.upper);
  }
  if (has_lower) return fmt::format("a finite number of at least {}", parameter.lower);
  if (has_upper) return fmt::format("a finite number of at most {}", parameter.upper);
  return "a finite number";
}

double ParseValue(const EffectInfo& info,
                  const EffectParameter& parameter,
                  const std::string& text) {
  const std::optional<double> value = ParseFiniteNumber(text);
  if (value && parameter.lower <= *value && *value <= parameter.upper) return *value;
  Fail(fmt::format(
      "{}'s {} is {}, expected {}.", info.name, parameter.name, Quoted(text), ValuesOf(parameter)));
}

std::vector<std::string_view> Keys(const EffectInfo& info) {
  std::vector<std::string_view> keys;
  for (const EffectParameter& parameter : info.parameters) keys.push_back(parameter.name);
  if (info.has_partner) keys.push_back("partner");
  return keys;
}

ActiveEffect ParseEffect(const std::string& text,
                         const Experiment& experiment,
                         const std::array<Scales, 6>& scales,
                         std::uint64_t seed) {
  const std::vector<std::string> parts = Split(text, ':');
  std::string name = parts[0];
  ActiveEffect active;
  active.setting.dof = experiment.drives.front().dof;
  const std::size_t dot = name.find('.');
  if (dot != std::string::npos && name.substr(0, dot) != "unlisted") {
    active.setting.dof = DrivenDof(name.substr(0, dot), experiment);
    name = name.substr(dot + 1);
  }
  active.effect = EffectOfName(name);
  const EffectInfo& info = active.effect->info();
  const Dof dof = active.setting.dof;

  std::vector<std::optional<double>> given(info.parameters.size());
  std::optional<Dof> partner;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const std::size_t equals = parts[i].find('=');
    const std::string key = parts[i].substr(0, equals);
    const std::string value = equals == std::string::npos ? "" : parts[i].substr(equals + 1);
    const auto keys = Keys(info);
    const auto found = std::find(keys.begin(), keys.end(), key);
    if (found == keys.end() || equals == std::string::npos) {
      Fail(fmt::format("{}: {} sets no parameter, expected {}=...",
                       info.name,
                       Quoted(parts[i]),
                       fmt::join(keys, "=... or ")));
    }
    const std::size_t place = static_cast<std::size_t>(found - keys.begin());
    if (place < given.size() ? given[place].has_value() : partner.has_value()) {
      Fail(fmt::format("{}: {} is given twice, expected once.", info.name, key));
    }
    if (place < given.size()) {
      given[place] = ParseValue(info, info.parameters[place], value);
      continue;
    }
    partner = DofFromName(value);
    if (!partner || !IsDriven(experiment, *partner) || !CanBePartner(info, dof, *partner)) {
      Fail(fmt::format("{}.{}'s partner is {}, expected {}.",
                       Name(dof),
                       info.name,
                       Quoted(value),
                       PartnerNames(info, dof, experiment)));
    }
  }
  if (info.has_partner) {
    active.setting.partner = partner ? *partner : FirstPartner(info, dof, experiment);
  }
  if (info.name == "coriolis_coupling" && !IsDriven(experiment, Dof::kYaw)) {
    Fail(fmt::format("{} needs yaw, expected an experiment that drives it.", info.name));
  }
  // A command of nothing but zeros has no size of its own.
  const double rms_force = scales[Index(dof)].force;
  if (rms_force > 0.0) active.setting.reference_force = rms_force;

  RandomStream random(seed, fmt::format("effect.{}.{}", Name(dof), info.name));
  active.values = DrawSizes(*active.effect, dof, active.setting.partner, scales, random);
  for (std::size_t i = 0; i < given.size(); ++i) {
    const EffectParameter& parameter = info.parameters[i];
    double& value = active.values[i];
    if (given[i]) value = *given[i];
    if (parameter.lower <= value && value <= parameter.upper && std::isfinite(value)) continue;
    Fail(
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

std::vector<ActiveEffect> ParseEffectList(const std::string& text,
                                          const Experiment& experiment,
                                          const std::array<Scales, 6>& scales,
                                          std::uint64_t seed) {
  std::vector<ActiveEffect> effects;
  if (text.empty()) return effects;
  for (const std::string& part : Split(text, ',')) {
    effects.push_back(ParseEffect(part, experiment, scales, seed));
    const ActiveEffect& last = effects.back();
    const auto is_same = [&](const ActiveEffect& other) {
      return other.effect == last.effect && other.setting.dof == last.setting.dof;
    };
    if (std::count_if(effects.begin(), effects.end(), is_same) > 1) {
      Fail(fmt::format("{}.{} is given twice, expected once.",
                       Name(last.setting.dof),
                       last.effect->info().name));
    }
  }
  if (effects.size() > EffectStates::MaxRowsAtCompileTime) {
    Fail(fmt::format("holds {} effects, expected at most {}.",
                     effects.size(),
                     int{EffectStates::MaxRowsAtCompileTime}));
  }
  return effects;
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
  if (info.has_partner) text += fmt::format(", partner {}", Name(active.setting.partner));
  return text;
}

}  // namespace fathom
