// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/not_known.h"
#include "fathom/base/quoted.h"
#include "fathom/vehicle/coupled/entry_name.h"
#include "fathom/vehicle/files/effect_entries.h"
#include "fathom/vehicle/files/figures_entry.h"
#include "fathom/vehicle/files/json_value.h"
#include "fathom/vehicle/files/model_file.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

// Every key that Fathom's tools write, whether it is read here or only told to a person.
const std::vector<std::string> kKeysOfModel = {"schema",
                                               "dof",
                                               "structure",
                                               "force_unit",
                                               "parameters",
                                               "covariance",
                                               "fit",
                                               "held_out",
                                               "caveats",
                                               "provenance",
                                               "thruster_shares",
                                               "logs",
                                               "log_fingerprints"};
const std::vector<std::string> kKeysOfFigures = {"mae", "nmae", "n", "duration"};
const std::vector<std::string> kKeysOfFit = {
    "mae", "nmae", "n", "duration", "residual_autoregression", "speed_range", "force_range"};
const std::vector<std::string> kKeysOfVerdict = {
    "schema",          "log",        "dof",          "verdict",           "sentence",
    "force_unit",      "figures_of", "has_baseline", "baseline",          "causes",
    "extended",        "findings",
    "structure_share",  // of older files
    "explained_share", "noise_nmae", "coincidence",  "remaining_p_value", "heldout_gain",
    "candidates",      "limits",     "logs",         "log_fingerprints",  "remarks"};
const std::vector<std::string> kKeysOfDiagnosedModel = {"parameters",
                                                        "mae",
                                                        "nmae",
                                                        "n",
                                                        "duration",
                                                        "heldout_mae",
                                                        "heldout_nmae",
                                                        "speed_range",
                                                        "force_range",
                                                        "structure",
                                                        "covariance",
                                                        "log_likelihood"};

std::vector<std::string> TextsIfThere(const JsonValue& json, const std::string& key) {
  const auto list = json.MemberIfThere(key);
  return list ? list->Texts() : std::vector<std::string>();
}

ValueRange ReadRange(const JsonValue& json) {
  const std::vector<JsonValue> ends = json.List();
  if (ends.size() != 2) {
    json.Fail(fmt::format("has {} entries, expected 2: the smallest and the greatest value",
                          ends.size()));
  }
  const ValueRange range = {ends[0].Number(), ends[1].Number()};
  if (range.low > range.high) {
    json.Fail(fmt::format("is {} to {}, expected the smaller value first", range.low, range.high));
  }
  return range;
}

// Of what holds the figures; both ranges or none.
std::optional<DataRange> ReadDataRange(const JsonValue& json) {
  if (!json.Has("speed_range") && !json.Has("force_range")) return std::nullopt;
  return DataRange{ReadRange(json.Member("speed_range")), ReadRange(json.Member("force_range"))};
}

// The effects of `model`, which is the file itself, or what a verdict holds under "extended". Where
// a verdict does not say, they are its causes; `values` then holds what these say.
std::vector<ActiveEffect> EffectsOf(const JsonValue& file,
                                    const JsonValue& model,
                                    const FittedModel& fitted,
                                    std::map<std::string, double>* values) {
  std::vector<ActiveEffect> causes;
  if (const auto list = file.MemberIfThere("causes")) {
    causes = ReadCauses(*list, fitted.dof, fitted.force_unit, values);
  }
  const auto structure = model.MemberIfThere("structure");
  if (!structure) return causes;
  values->clear();
  return ReadEffects(*structure, fitted.dof);
}

// Families that do not bound the damping. With them it may come out below 0, which a caveat says.
const std::set<std::string> kUnboundedFamilies = {"adaptive", "least_squares"};

// Throws InputError for what no vehicle can have.
void RequirePhysical(const JsonValue& parameters,
                     const ParameterVector& baseline,
                     const std::string& family) {
  if (!(baseline[kInertia] > 0.0)) {
    parameters.Member("inertia").Fail(
        fmt::format("is {}, expected a value above 0", baseline[kInertia]));
  }
  if (kUnboundedFamilies.contains(family)) return;
  for (const int index : {kQuadraticDamping, kLinearDamping}) {
    if (baseline[index] >= 0.0) continue;
    parameters.Member(kParameterInfo[index].name)
        .Fail(fmt::format("is {}, expected at least 0, but for a model of the family {}",
                          baseline[index],
                          fmt::join(kUnboundedFamilies, " or ")));
  }
}

void ReadParameters(const JsonValue& parameters,
                    const std::map<std::string, double>& values,
                    const std::string& family,
                    FittedModel* fitted) {
  std::vector<std::string> keys;
  std::vector<double> variances;
  const auto read = [&](const std::string& key, const std::string& unit) {
    keys.push_back(key);
    const auto given = values.find(key);
    if (given != values.end() && !parameters.Has(key)) {
      variances.push_back(kNotKnown);
      return given->second;
    }
    const ParameterEntry entry = ReadParameter(parameters.Member(key), unit);
    variances.push_back(entry.std * entry.std);
    return entry.value;
  };
  ParameterVector baseline;
  for (int i = 0; i < kNumParameters; ++i) {
    baseline[i] = read(kParameterInfo[i].name, ParameterUnit(i, fitted->dof, fitted->force_unit));
  }
  RequirePhysical(parameters, baseline, family);
  fitted->model = ModelFromVector(baseline);
  for (ActiveEffect& active : fitted->effects) {
    for (const EffectParameter& parameter : active.effect->info().parameters) {
      const std::string key = KeyOf(active, parameter);
      const double value = read(key, UnitOf(parameter.quantity, fitted->dof, fitted->force_unit));
      if (!(value >= parameter.lower && value <= parameter.upper)) {
        const JsonValue place = parameters.Has(key) ? parameters.Member(key) : parameters;
        place.Fail(
            fmt::format("is {}, expected {} to {}", value, parameter.lower, parameter.upper));
      }
      active.values.push_back(value);
    }
  }
  for (const std::string& key : parameters.Keys()) {
    if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
    parameters.Member(key).Fail(fmt::format(
        "is a parameter of no effect of this model, expected {}", fmt::join(keys, ", ")));
  }
  const auto size = static_cast<Eigen::Index>(keys.size());
  fitted->covariance.setConstant(size, size, kNotKnown);
  for (Eigen::Index i = 0; i < size; ++i) fitted->covariance(i, i) = variances[i];
}

void ReadCovariance(const JsonValue& json, FittedModel* fitted) {
  const Eigen::Index size = fitted->covariance.rows();
  const auto list_of_size = [&](const JsonValue& value) {
    std::vector<JsonValue> list = value.List();
    if (static_cast<Eigen::Index>(list.size()) != size) {
      value.Fail(fmt::format(
          "has {} entries, expected a {} x {} array of numbers or nulls", list.size(), size, size));
    }
    return list;
  };
  Eigen::Index i = 0;
  for (const JsonValue& row : list_of_size(json)) {
    Eigen::Index j = 0;
    for (const JsonValue& value : list_of_size(row)) {
      fitted->covariance(i, j++) = value.NumberIfKnown();
    }
    ++i;
  }
}

// By which the model came about; empty where the file does not say.
std::string FamilyOf(const JsonValue& file) {
  const auto provenance = file.MemberIfThere("provenance");
  return provenance && provenance->Has("family") ? provenance->Member("family").Text() : "";
}

// Throws InputError for a key that no tool writes.
void RequireKnownKeys(const JsonValue& file, bool is_verdict) {
  file.RequireKeysOf(is_verdict ? kKeysOfVerdict : kKeysOfModel);
  if (!is_verdict) return;
  for (const char* model : {"baseline", "extended"}) {
    if (const auto json = file.MemberIfThere(model)) json->RequireKeysOf(kKeysOfDiagnosedModel);
  }
}

}  // namespace

FittedModel ParseModel(const std::string& name, std::string_view text) {
  const JsonValue file = JsonValue::Parse(name, text);
  const JsonValue schema = file.Member("schema");
  const bool is_verdict = schema.Text() == "fathom-verdict-1";
  if (schema.Text() != "fathom-model-1" && !is_verdict) {
    schema.Fail(fmt::format(
        "is {}, expected that of a model or verdict: 'fathom-model-1', 'fathom-verdict-1' or, of "
        "several DOFs, 'fathom-model-2', 'fathom-verdict-2'",
        Quoted(schema.Text())));
  }
  RequireKnownKeys(file, is_verdict);
  const JsonValue model = is_verdict ? file.Member("extended") : file;
  FittedModel fitted;
  const JsonValue dof_name = file.Member("dof");
  const auto dof = DofFromName(dof_name.Text());
  if (!dof) dof_name.Fail("is not one of surge, sway, heave, roll, pitch, yaw");
  fitted.dof = *dof;
  const auto force_unit = file.MemberIfThere("force_unit");
  fitted.force_unit = force_unit ? force_unit->Text() : std::string(ForceUnit(*dof));
  fitted.caveats = TextsIfThere(file, "caveats");
  std::map<std::string, double> values;
  fitted.effects = EffectsOf(file, model, fitted, &values);
  ReadParameters(model.Member("parameters"), values, FamilyOf(file), &fitted);
  if (const auto covariance = model.MemberIfThere("covariance")) {
    ReadCovariance(*covariance, &fitted);
  }
  if (is_verdict) {
    fitted.train = ReadFigures(model);
    fitted.range = ReadDataRange(model);
    fitted.held_out.mae = model.NumberIfThere("heldout_mae");
    fitted.held_out.nmae = model.NumberIfThere("heldout_nmae");
  } else {
    if (const auto fit = file.MemberIfThere("fit")) {
      fit->RequireKeysOf(kKeysOfFit);
      fitted.train = ReadFigures(*fit);
      if (const auto colour = fit->MemberIfThere("residual_autoregression")) {
        std::vector<double>& phi = fitted.residual_autoregression.emplace();
        for (const JsonValue& value : colour->List()) phi.push_back(value.Number());
      }
      fitted.range = ReadDataRange(*fit);
    }
    if (const auto held_out = file.MemberIfThere("held_out")) {
      held_out->RequireKeysOf(kKeysOfFigures);
      fitted.held_out = ReadFigures(*held_out);
    }
  }
  if (const auto shares = file.MemberIfThere("thruster_shares")) {
    for (const std::string& thruster : shares->Keys()) {
      fitted.thruster_shares[thruster] = shares->Member(thruster).Number();
    }
  }
  fitted.log_fingerprints = TextsIfThere(file, "log_fingerprints");
  fitted.logs = TextsIfThere(file, "logs");
  return fitted;
}

}  // namespace fathom
