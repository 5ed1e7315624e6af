// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/effects/given_effect.h"

#include "fathom/base/input_error.h"
#include "fathom/base/nearest.h"
#include "fathom/base/number.h"
#include "fathom/base/quoted.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

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
  FailEffects(fmt::format("{} is not a DOF that the experiment drives, expected one of {}.",
                          Quoted(name),
                          DrivenNames(experiment)));
}

const Effect* EffectOfName(const std::string& name, std::span<const Effect* const> effects) {
  std::vector<std::string> names;
  for (const Effect* effect : effects) {
    if (effect->info().name == name) return effect;
    names.emplace_back(effect->info().name);
  }
  const std::string near = Nearest(name, names);
  FailEffects(near.empty() ? fmt::format("{} is no effect, expected one of {}.",
                                         Quoted(name),
                                         fmt::join(names, ", "))
                           : fmt::format("{} is no effect, did you mean {}?", Quoted(name), near));
}

// The DOF that an effect acts along where none is given: the experiment's first that it can.
Dof FirstDof(const EffectInfo& info, const Experiment& experiment) {
  for (const Drive& drive : experiment.drives) {
    if (CanActAlong(info, drive.dof)) return drive.dof;
  }
  return experiment.drives.front().dof;
}

void RequireActsAlong(const EffectInfo& info, Dof dof) {
  if (CanActAlong(info, dof)) return;
  std::vector<std::string_view> names;
  for (const Dof other : kAllDofs) {
    if (CanActAlong(info, other)) names.push_back(Name(other));
  }
  FailEffects(fmt::format("{} does not act along {}, expected an experiment that drives {}.",
                          info.name,
                          Name(dof),
                          fmt::join(names, " or ")));
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
  FailEffects(fmt::format("{}.{} needs another DOF that takes part, expected {}.",
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
  FailEffects(fmt::format(
      "{}'s {} is {}, expected {}.", info.name, parameter.name, Quoted(text), ValuesOf(parameter)));
}

std::vector<std::string_view> Keys(const EffectInfo& info) {
  std::vector<std::string_view> keys;
  for (const EffectParameter& parameter : info.parameters) keys.push_back(parameter.name);
  if (info.has_partner()) keys.push_back("partner");
  return keys;
}

// "partner=yaw": one key and its value, of an effect whose DOF is known.
void ParseKey(const std::string& text,
              const Experiment& experiment,
              GivenEffect* given,
              std::optional<Dof>* partner) {
  const EffectInfo& info = given->effect->info();
  const std::size_t equals = text.find('=');
  const std::string key = text.substr(0, equals);
  const std::string value = equals == std::string::npos ? "" : text.substr(equals + 1);
  const auto keys = Keys(info);
  const auto found = std::find(keys.begin(), keys.end(), key);
  if (found == keys.end() || equals == std::string::npos) {
    FailEffects(fmt::format("{}: {} sets no parameter, expected {}=...",
                            info.name,
                            Quoted(text),
                            fmt::join(keys, "=... or ")));
  }
  const std::size_t place = static_cast<std::size_t>(found - keys.begin());
  const bool is_value = place < given->values.size();
  if (is_value ? given->values[place].has_value() : partner->has_value()) {
    FailEffects(fmt::format("{}: {} is given twice, expected once.", info.name, key));
  }
  if (is_value) {
    given->values[place] = ParseValue(info, info.parameters[place], value);
    return;
  }
  *partner = DofFromName(value);
  if (*partner && IsDriven(experiment, **partner) && CanBePartner(info, given->dof, **partner)) {
    return;
  }
  FailEffects(fmt::format("{}.{}'s partner is {}, expected {}.",
                          Name(given->dof),
                          info.name,
                          Quoted(value),
                          PartnerNames(info, given->dof, experiment)));
}

}  // namespace

GivenEffect ParseGivenEffect(const std::string& text,
                             const Experiment& experiment,
                             std::span<const Effect* const> effects) {
  const std::vector<std::string> parts = Split(text, ':');
  std::string name = parts[0];
  GivenEffect given;
  std::optional<Dof> dof;
  const std::size_t dot = name.find('.');
  if (dot != std::string::npos && name.substr(0, dot) != "unlisted") {
    dof = DrivenDof(name.substr(0, dot), experiment);
    name = name.substr(dot + 1);
  }
  given.effect = EffectOfName(name, effects);
  const EffectInfo& info = given.effect->info();
  given.dof = dof ? *dof : FirstDof(info, experiment);
  RequireActsAlong(info, given.dof);
  given.values.resize(info.parameters.size());
  std::optional<Dof> partner;
  for (std::size_t i = 1; i < parts.size(); ++i) ParseKey(parts[i], experiment, &given, &partner);
  if (!info.partner) return given;
  given.partner = partner ? *partner : FirstPartner(info, given.dof, experiment);
  if (info.partner->yaw_rate && !IsDriven(experiment, Dof::kYaw)) {
    FailEffects(fmt::format("{} needs yaw, expected an experiment that drives it.", info.name));
  }
  return given;
}

void FailEffects(const std::string& message) { throw InputError("--effects: " + message); }

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

}  // namespace fathom
