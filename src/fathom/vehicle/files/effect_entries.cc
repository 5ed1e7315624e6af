// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/files/effect_entries.h"

#include "fathom/base/quoted.h"
#include "fathom/vehicle/effects/catalogue.h"
#include "fathom/vehicle/files/model_file.h"

#include <algorithm>
#include <limits>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

// What stands beside an effect in a verdict's causes, for a reader.
const std::vector<std::string> kKeysOfCause = {"place",
                                               "parameters",
                                               "thruster",
                                               "p_value",
                                               "delta_bic",
                                               "heldout_gain",
                                               "alternatives",
                                               "experiment",
                                               "scope",
                                               "because",
                                               "advice"};

const Effect& EffectNamedIn(const JsonValue& json) {
  const std::string name = json.Text();
  if (const Effect* effect = FindEffect(name)) return *effect;
  std::vector<std::string_view> names;
  for (const Effect* effect : EffectCatalogue()) names.push_back(effect->info().name);
  json.Fail(fmt::format("is {}, an effect that this version cannot simulate, expected one of {}",
                        Quoted(name),
                        fmt::join(names, ", ")));
}

Dof PartnerIn(const JsonValue& json, std::string_view effect, Dof dof) {
  const std::string name = json.Text();
  const auto partner = DofFromName(name);
  if (partner && *partner != dof) return *partner;
  json.Fail(
      fmt::format("of {} is {}, expected another DOF than {}: surge, sway, heave, roll, "
                  "pitch or yaw",
                  effect,
                  Quoted(name),
                  Name(dof)));
}

// One entry, without its values, which may have `more_keys`.
ActiveEffect ReadEffect(const JsonValue& json, Dof dof, const std::vector<std::string>& more_keys) {
  ActiveEffect active = ReadSetEffect(json, dof);
  std::vector<std::string> keys = {"effect", "reference_force", "log"};
  if (active.effect->info().has_partner()) keys.insert(keys.begin() + 1, "partner");
  keys.insert(keys.end(), more_keys.begin(), more_keys.end());
  json.RequireKeysOf(keys);
  return active;
}

}  // namespace

ActiveEffect ReadSetEffect(const JsonValue& json, Dof dof) {
  ActiveEffect active;
  active.effect = &EffectNamedIn(json.Member("effect"));
  active.setting.dof = dof;
  const EffectInfo& info = active.effect->info();
  if (!CanActAlong(info, dof)) {
    json.Member("effect").Fail(fmt::format(
        "is {}, an effect that does not act along {}", Quoted(std::string(info.name)), Name(dof)));
  }
  if (info.has_partner()) {
    active.setting.partner = PartnerIn(json.Member("partner"), info.name, dof);
  }
  if (const auto force = json.MemberIfThere("reference_force")) {
    active.setting.reference_force = force->Number();
    if (!(active.setting.reference_force > 0.0)) {
      force->Fail(fmt::format("is {}, expected a value above 0", active.setting.reference_force));
    }
  }
  if (const auto log = json.MemberIfThere("log")) active.setting.log = log->Text();
  return active;
}

std::vector<ActiveEffect> ReadEffects(const JsonValue& structure, Dof dof) {
  structure.RequireKeysOf({"baseline", "effects"});
  if (const auto baseline = structure.MemberIfThere("baseline")) {
    const std::string name = baseline->Text();
    if (name != "uncoupled") {
      baseline->Fail(fmt::format("is {}, expected 'uncoupled'", Quoted(name)));
    }
  }
  std::vector<ActiveEffect> effects;
  const auto list = structure.MemberIfThere("effects");
  if (!list) return effects;
  for (const JsonValue& json : list->List()) effects.push_back(ReadEffect(json, dof, {}));
  if (const std::string problem = ProblemWith(effects); !problem.empty()) list->Fail(problem);
  return effects;
}

std::vector<ActiveEffect> ReadCauses(const JsonValue& causes,
                                     Dof dof,
                                     const std::string& force_unit,
                                     std::map<std::string, double>* values) {
  std::vector<ActiveEffect> effects;
  for (const JsonValue& json : causes.List()) {
    const ActiveEffect& active = effects.emplace_back(ReadEffect(json, dof, kKeysOfCause));
    const JsonValue parameters = json.Member("parameters");
    std::vector<std::string> names;
    for (const EffectParameter& parameter : active.effect->info().parameters) {
      const std::string unit = UnitOf(parameter.quantity, dof, force_unit);
      const std::string& name = names.emplace_back(parameter.name);
      (*values)[KeyOf(active, parameter)] = ReadParameter(parameters.Member(name), unit).value;
    }
    parameters.RequireKeysOf(names);
  }
  std::stable_sort(effects.begin(), effects.end(), [](const auto& a, const auto& b) {
    return ActsBefore(a.effect, b.effect);
  });
  if (const std::string problem = ProblemWith(effects); !problem.empty()) causes.Fail(problem);
  return effects;
}

ParameterEntry ReadParameter(const JsonValue& json, const std::string& unit) {
  json.RequireKeysOf({"value", "std", "unit"});
  ParameterEntry entry = {json.Member("value").Number(), std::numeric_limits<double>::quiet_NaN()};
  if (const auto std = json.MemberIfThere("std")) {
    entry.std = std->NumberIfKnown();
    if (entry.std < 0.0) std->Fail(fmt::format("is {}, expected at least 0", entry.std));
  }
  if (const auto given = json.MemberIfThere("unit"); given && given->Text() != unit) {
    given->Fail(fmt::format("is {}, expected {}", Quoted(given->Text()), Quoted(unit)));
  }
  return entry;
}

}  // namespace fathom
