// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/files/coupled_model_file.h"

#include "fathom/base/files/input_file.h"
#include "fathom/base/files/json_text.h"
#include "fathom/base/input_error.h"
#include "fathom/base/quoted.h"
#include "fathom/vehicle/coupled/entry_name.h"
#include "fathom/vehicle/coupled/entry_value.h"
#include "fathom/vehicle/files/effect_entries.h"
#include "fathom/vehicle/files/figures_entry.h"
#include "fathom/vehicle/files/json_value.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kSchema = "fathom-model-2";
constexpr std::string_view kVerdictSchema = "fathom-verdict-2";  // holds a model

const std::vector<std::string> kKeysOfCoupled = {"schema",
                                                 "dofs",
                                                 "structure",
                                                 "coriolis",
                                                 "force_unit",
                                                 "parameters",
                                                 "held",
                                                 "covariance",
                                                 "horizon",
                                                 "fit",
                                                 "held_out",
                                                 "caveats",
                                                 "provenance",
                                                 "log_fingerprints"};

// Of each modelled DOF, by its name.
Json FormatByDof(const std::array<FitFigures, 6>& figures, const std::vector<Dof>& dofs) {
  Json json = Json::object();
  for (const Dof dof : dofs) {
    json[std::string(Name(dof))] =
        JsonOfFigures<Json>(figures[static_cast<std::size_t>(Index(dof))]);
  }
  return json;
}

// The figures of the fit, and the colour of its noise where it is known.
Json FormatFitByDof(const FittedCoupledModel& fitted) {
  Json json = FormatByDof(fitted.train, fitted.model.dofs);
  for (const Dof dof : fitted.model.dofs) {
    const auto& colour = fitted.residual_autoregression[static_cast<std::size_t>(Index(dof))];
    if (colour) json[std::string(Name(dof))]["residual_autoregression"] = *colour;
  }
  return json;
}

// What a model holds beside its identified numbers.
Json FormatHeld(const FittedCoupledModel& fitted) {
  Json held = Json::object();
  for (const FreeEntry& entry : EntriesIn(fitted.model)) {
    const bool is_free =
        std::find(fitted.entries.begin(), fitted.entries.end(), entry) != fitted.entries.end();
    if (!is_free) held[NameOf(entry)] = ValueIn(fitted.model, entry);
  }
  return held;
}

std::vector<Dof> ReadDofs(const JsonValue& json) {
  std::vector<Dof> dofs;
  for (const std::string& name : json.Texts()) {
    const auto dof = DofFromName(name);
    if (!dof) json.Fail(fmt::format("holds {}, expected names of DOFs", Quoted(name)));
    if (!dofs.empty() && *dof <= dofs.back()) {
      json.Fail("is not in the order surge, sway, heave, roll, pitch, yaw, each once");
    }
    dofs.push_back(*dof);
  }
  if (dofs.empty()) json.Fail("is empty, expected at least one DOF");
  return dofs;
}

FreeEntry ReadEntry(const JsonValue& json, const std::string& key, const std::vector<Dof>& dofs) {
  FreeEntry entry;
  try {
    entry = ParseFreeEntry(key);
  } catch (const InputError& error) {
    json.Fail(fmt::format("holds a wrong key: {}", error.what()));
  }
  const bool has_row = !IsOfActuator(entry) && entry.kind != FreeEntry::Kind::kNetBuoyancy;
  if (has_row && std::find(dofs.begin(), dofs.end(), entry.row) == dofs.end()) {
    json.Fail(fmt::format("holds {}, whose DOF is none of 'dofs'", Quoted(key)));
  }
  return entry;
}

// Two spellings name one number: inertia.sway.yaw and inertia.yaw.sway.
void RequireOnce(const JsonValue& json,
                 const std::string& key,
                 const FreeEntry& entry,
                 std::vector<FreeEntry>* read) {
  if (std::find(read->begin(), read->end(), entry) != read->end()) {
    json.Fail(fmt::format("holds {}, which the file holds already, expected once", Quoted(key)));
  }
  read->push_back(entry);
}

void SetEntry(const JsonValue& json, const FreeEntry& entry, double value, CoupledModel* model) {
  if (IsLag(entry) && value < 0.0) {
    json.Fail(fmt::format("is {} s, expected a time constant of at least 0 s", value));
  }
  if (!MayBe(entry, value)) {
    json.Fail(fmt::format("is {}, which {} cannot be", value, NameOf(entry)));
  }
  SetValue(entry, value, model);
}

std::array<FitFigures, 6> ReadByDof(const JsonValue& json) {
  std::array<FitFigures, 6> figures;
  for (const std::string& name : json.Keys()) {
    const auto dof = DofFromName(name);
    if (!dof) json.Fail(fmt::format("holds {}, expected names of DOFs", Quoted(name)));
    figures[static_cast<std::size_t>(Index(*dof))] = ReadFigures(json.Member(name));
  }
  return figures;
}

// Of the DOFs that ReadByDof() has read.
void ReadColours(const JsonValue& fit, FittedCoupledModel* fitted) {
  for (const std::string& name : fit.Keys()) {
    const auto colour = fit.Member(name).MemberIfThere("residual_autoregression");
    if (!colour) continue;
    const auto at = static_cast<std::size_t>(Index(*DofFromName(name)));
    std::vector<double>& phi = fitted->residual_autoregression[at].emplace();
    for (const JsonValue& value : colour->List()) phi.push_back(value.Number());
  }
}

Eigen::MatrixXd ReadCovariance(const JsonValue& json, std::size_t size) {
  const auto n = static_cast<Eigen::Index>(size);
  Eigen::MatrixXd covariance(n, n);
  const std::vector<JsonValue> rows = json.List();
  if (rows.size() != size) {
    json.Fail(
        fmt::format("has {} rows, expected one for each of {} parameters", rows.size(), size));
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::vector<JsonValue> row = rows[static_cast<std::size_t>(i)].List();
    if (row.size() != size) {
      rows[static_cast<std::size_t>(i)].Fail(
          fmt::format("has {} entries, expected {}", row.size(), size));
    }
    for (Eigen::Index j = 0; j < n; ++j) {
      covariance(i, j) = row[static_cast<std::size_t>(j)].NumberIfKnown();
    }
  }
  return covariance;
}

}  // namespace

std::string FormatCoupledModel(const FittedCoupledModel& fitted) {
  Json dofs = Json::array(), parameters = Json::object(), covariance = Json::array();
  for (const Dof dof : fitted.model.dofs) dofs.push_back(Name(dof));
  for (std::size_t k = 0; k < fitted.entries.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(k);
    parameters[NameOf(fitted.entries[k])] = {
        {"value", ValueIn(fitted.model, fitted.entries[k])},
        {"std", std::sqrt(fitted.covariance(at, at))},
        {"unit", UnitOf(fitted.entries[k], fitted.force_unit)}};
    Json row = Json::array();
    for (Eigen::Index j = 0; j < fitted.covariance.cols(); ++j) {
      row.push_back(fitted.covariance(at, j));
    }
    covariance.push_back(row);
  }
  const Json json = {{"schema", kSchema},
                     {"dofs", dofs},
                     {"structure", fitted.structure},
                     {"coriolis", fitted.model.coriolis},
                     {"force_unit", fitted.force_unit},
                     {"parameters", parameters},
                     {"held", FormatHeld(fitted)},
                     {"covariance", covariance},
                     {"horizon", fitted.horizon},
                     {"fit", FormatFitByDof(fitted)},
                     {"held_out", FormatByDof(fitted.held_out, fitted.model.dofs)},
                     {"caveats", fitted.caveats},
                     {"provenance", fitted.provenance},
                     {"log_fingerprints", fitted.log_fingerprints}};
  return JsonText(json);
}

FittedCoupledModel ParseCoupledModel(const std::string& name, std::string_view text) {
  const JsonValue whole = JsonValue::Parse(name, text);
  const bool is_verdict = whole.Member("schema").Text() == kVerdictSchema;
  const JsonValue file = is_verdict ? whole.Member("model") : whole;
  if (const std::string schema = file.Member("schema").Text(); schema != kSchema) {
    file.Member("schema").Fail(fmt::format("is {}, expected \"{}\"", Quoted(schema), kSchema));
  }
  file.RequireKeysOf(kKeysOfCoupled);
  FittedCoupledModel fitted;
  fitted.model.dofs = ReadDofs(file.Member("dofs"));
  fitted.structure = file.Member("structure").Text();
  fitted.model.coriolis = file.Member("coriolis").Boolean();
  fitted.force_unit = file.Member("force_unit").Text();
  const JsonValue parameters = file.Member("parameters");
  std::vector<FreeEntry> read;
  for (const std::string& key : parameters.Keys()) {
    const FreeEntry entry = ReadEntry(parameters, key, fitted.model.dofs);
    RequireOnce(parameters, key, entry, &read);
    const JsonValue parameter = parameters.Member(key);
    SetEntry(parameter,
             entry,
             ReadParameter(parameter, UnitOf(entry, fitted.force_unit)).value,
             &fitted.model);
  }
  fitted.entries = read;
  if (const auto held = file.MemberIfThere("held")) {
    for (const std::string& key : held->Keys()) {
      const FreeEntry entry = ReadEntry(*held, key, fitted.model.dofs);
      RequireOnce(*held, key, entry, &read);
      const JsonValue number = held->Member(key);
      SetEntry(number, entry, number.Number(), &fitted.model);
    }
  }
  if (!IsPositiveDefinite(fitted.model.inertia, fitted.model.dofs)) {
    parameters.Fail("hold an inertia that is not positive definite");
  }
  if (const auto fin = FinWithLagAndRateLimit(fitted.model)) {
    parameters.Fail(fmt::format(
        "and 'held' give fin {} both a fin_lag and a fin_rate_limit, expected one of them", *fin));
  }
  fitted.covariance = ReadCovariance(file.Member("covariance"), fitted.entries.size());
  fitted.horizon = file.NumberIfThere("horizon");
  if (const auto fit = file.MemberIfThere("fit")) {
    fitted.train = ReadByDof(*fit);
    ReadColours(*fit, &fitted);
  }
  if (const auto held_out = file.MemberIfThere("held_out")) fitted.held_out = ReadByDof(*held_out);
  if (const auto caveats = file.MemberIfThere("caveats")) fitted.caveats = caveats->Texts();
  if (const auto provenance = file.MemberIfThere("provenance")) {
    for (const std::string& key : provenance->Keys()) {
      fitted.provenance[key] = provenance->Member(key).Text();
    }
  }
  if (const auto prints = file.MemberIfThere("log_fingerprints")) {
    fitted.log_fingerprints = prints->Texts();
  }
  return fitted;
}

FittedCoupledModel ReadCoupledModel(const std::filesystem::path& path) {
  return ParseCoupledModel(path.string(), ReadFile(path));
}

bool IsCoupledModel(std::string_view text) {
  try {
    const JsonValue file = JsonValue::Parse("", text);
    if (!file.Has("schema")) return false;
    const std::string schema = file.Member("schema").Text();
    return schema == kSchema || schema == kVerdictSchema;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace fathom
