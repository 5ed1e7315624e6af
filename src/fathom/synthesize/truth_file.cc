// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/truth_file.h"

#include "fathom/vehicle/coupled/entry_name.h"
#include "fathom/vehicle/coupled/entry_value.h"
#include "fathom/vehicle/coupled/free_entry.h"
#include "fathom/vehicle/effects/catalogue.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using Json = nlohmann::ordered_json;

Json ModelOf(Dof dof, const UncoupledModel<double>& model) {
  const ParameterVector values = ToVector(model);
  Json json = Json::object();
  for (int i = 0; i < kNumParameters; ++i) {
    json[kParameterInfo[i].name] = {{"value", values[i]},
                                    {"unit", ParameterUnit(i, dof, std::string(ForceUnit(dof)))}};
  }
  return json;
}

// Whether it is a number of a matrix that no modelled DOF feels: matrices hold the whole body.
bool IsBesideTheModel(const FreeEntry& entry, const std::vector<Dof>& dofs) {
  using Kind = FreeEntry::Kind;
  const bool is_of_matrix = entry.kind == Kind::kInertia || entry.kind == Kind::kLinearDamping ||
                            entry.kind == Kind::kQuadraticDamping || entry.kind == Kind::kLift;
  const auto is_modelled = [&](Dof dof) { return std::ranges::count(dofs, dof) > 0; };
  return is_of_matrix && !(is_modelled(entry.row) && is_modelled(entry.column));
}

// Every number that acts and is not at its null, by its name in docs/coupled.md.
Json CoupledOfTruth(const CoupledModel& model) {
  Json dofs = Json::array(), parameters = Json::object();
  for (const Dof dof : model.dofs) dofs.push_back(Name(dof));
  for (const FreeEntry& entry : EntriesIn(model)) {
    if (IsBesideTheModel(entry, model.dofs)) continue;
    parameters[NameOf(entry)] = {{"value", ValueIn(model, entry)}, {"unit", UnitOf(entry)}};
  }
  return {{"dofs", dofs}, {"coriolis", model.coriolis}, {"parameters", parameters}};
}

Json EffectOfTruth(const ActiveEffect& active) {
  const EffectInfo& info = active.effect->info();
  const Dof dof = active.setting.dof;
  Json parameters = Json::object();
  for (std::size_t i = 0; i < info.parameters.size(); ++i) {
    const EffectParameter& parameter = info.parameters[i];
    parameters[std::string(parameter.name)] = {
        {"value", active.values[i]},
        {"unit", UnitOf(parameter.quantity, dof, std::string(ForceUnit(dof)))}};
  }
  Json json = {{"effect", info.name},
               {"dof", Name(dof)},
               {"place", Name(info.place)},
               {"in_catalogue", FindEffect(info.name) == active.effect},
               {"parameters", parameters}};
  if (info.has_partner()) json["partner"] = Name(active.setting.partner);
  if (info.uses_reference_force) json["reference_force"] = active.setting.reference_force;
  return json;
}

}  // namespace

std::string FormatTruth(const Vehicle& vehicle,
                        const Experiment& experiment,
                        std::span<const ActiveEffect> effects,
                        std::uint64_t seed) {
  Json hidden = Json::array();
  for (const ActiveEffect& active : effects) hidden.push_back(EffectOfTruth(active));
  if (vehicle.coupled) {
    Json json = {{"schema", "fathom-truth-1"},
                 {"vehicle", vehicle.name},
                 {"experiment", experiment.name},
                 {"seed", seed},
                 {"coupled_model", CoupledOfTruth(*vehicle.coupled)},
                 {"effects", hidden}};
    if (!experiment.current.isZero(0.0)) {
      json["current"] = {{"north", experiment.current[0]}, {"east", experiment.current[1]}};
    }
    return json.dump(2) + "\n";
  }
  Json models = Json::object();
  for (const Drive& drive : experiment.drives) {
    models[std::string(Name(drive.dof))] =
        ModelOf(drive.dof, vehicle.models[Index(drive.dof)].value());
  }
  const Json json = {{"schema", "fathom-truth-1"},
                     {"vehicle", vehicle.name},
                     {"experiment", experiment.name},
                     {"seed", seed},
                     {"models", models},
                     {"effects", hidden}};
  return json.dump(2) + "\n";
}

}  // namespace fathom
