// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/input_error.h"
#include "fathom/base/quoted.h"
#include "fathom/vehicle/effects/catalogue.h"
#include "fathom/vehicle/files/model_file.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kDeepestNesting = 16;
constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();

// Walks a parsed file and complains in the words of docs/file_formats.md.
class Reader {
 public:
  explicit Reader(std::string name) : name_(std::move(name)) {}

  [[noreturn]] void Fail(const std::string& key, const std::string& what) const {
    throw InputError(fmt::format("{}: '{}' {}.", name_, key, what));
  }

  const Json& Member(const Json& object, const std::string& key) const {
    if (!object.is_object() || !object.contains(key)) Fail(key, "is missing");
    return object.at(key);
  }

  std::string Text(const Json& object, const std::string& key) const {
    const Json& value = Member(object, key);
    if (!value.is_string()) Fail(key, fmt::format("is {}, expected a text", Shortened(value)));
    return value.get<std::string>();
  }

  double Number(const Json& object, const std::string& key) const {
    const Json& value = Member(object, key);
    if (!value.is_number() || !std::isfinite(value.get<double>())) {
      Fail(key, fmt::format("is {}, expected a finite number", Shortened(value)));
    }
    return value.get<double>();
  }

  // Null where the file says nothing.
  const Json* ListIfThere(const Json& object, const std::string& key) const {
    if (!object.is_object() || !object.contains(key)) return nullptr;
    const Json& value = object.at(key);
    if (!value.is_array()) Fail(key, fmt::format("is {}, expected a list", Shortened(value)));
    return &value;
  }

  // None where the file says nothing.
  std::vector<std::string> TextsIfThere(const Json& object, const std::string& key) const {
    std::vector<std::string> texts;
    if (const Json* list = ListIfThere(object, key)) {
      for (const Json& text : *list) {
        if (!text.is_string()) Fail(key, "is not a list of texts");
        texts.push_back(text.get<std::string>());
      }
    }
    return texts;
  }

  // NaN where the file says null or nothing.
  double NumberIfKnown(const Json& object, const std::string& key) const {
    if (!object.is_object() || !object.contains(key) || object.at(key).is_null()) return kNotKnown;
    return Number(object, key);
  }

 private:
  static std::string Shortened(const Json& value) {
    const std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
    return text.size() <= 40 ? text : text.substr(0, 40) + "...";
  }

  const std::string name_;
};

FitFigures ReadFigures(const Reader& reader, const Json& json, const char* key) {
  if (!json.contains(key) || !json.at(key).is_object()) return {};
  const Json& object = json.at(key);
  FitFigures figures;
  figures.mae = reader.NumberIfKnown(object, "mae");
  figures.nmae = reader.NumberIfKnown(object, "nmae");
  return figures;
}

// One entry of structure.effects or causes, without its values.
ActiveEffect ReadEffect(const Reader& reader, const Json& json, Dof dof) {
  const std::string name = reader.Text(json, "effect");
  ActiveEffect active;
  active.effect = FindEffect(name);
  if (active.effect == nullptr) {
    std::vector<std::string_view> names;
    for (const Effect* effect : EffectCatalogue()) names.push_back(effect->info().name);
    reader.Fail(
        "effect",
        fmt::format("is {}, an effect that this version cannot simulate, expected one of {}",
                    Quoted(name),
                    fmt::join(names, ", ")));
  }
  active.setting.dof = dof;
  if (active.effect->info().has_partner()) {
    const std::string partner = reader.Text(json, "partner");
    const auto partner_dof = DofFromName(partner);
    if (!partner_dof || *partner_dof == dof) {
      reader.Fail(
          "partner",
          fmt::format("of {} is {}, expected another DOF than {}: surge, sway, heave, roll, "
                      "pitch or yaw",
                      name,
                      Quoted(partner),
                      Name(dof)));
    }
    active.setting.partner = *partner_dof;
  }
  if (json.contains("reference_force")) {
    active.setting.reference_force = reader.Number(json, "reference_force");
    if (!(active.setting.reference_force > 0.0)) {
      reader.Fail("reference_force",
                  fmt::format("is {}, expected a value above 0", active.setting.reference_force));
    }
  }
  if (json.contains("log")) active.setting.log = reader.Text(json, "log");
  return active;
}

// The effects of a model (of a verdict: of what it holds under "extended") without their values.
// Where a verdict does not say, they are its causes; `values` then holds what these say.
std::vector<ActiveEffect> ReadEffects(const Reader& reader,
                                      const Json& file,
                                      const Json& model,
                                      Dof dof,
                                      std::map<std::string, double>* values) {
  std::vector<ActiveEffect> effects;
  if (model.contains("structure")) {
    if (const Json* list = reader.ListIfThere(model.at("structure"), "effects")) {
      for (const Json& json : *list) effects.push_back(ReadEffect(reader, json, dof));
    }
  } else if (const Json* causes = reader.ListIfThere(file, "causes")) {
    for (const Json& json : *causes) {
      const ActiveEffect& active = effects.emplace_back(ReadEffect(reader, json, dof));
      for (const EffectParameter& parameter : active.effect->info().parameters) {
        const std::string name(parameter.name);
        const Json& given = reader.Member(reader.Member(json, "parameters"), name);
        (*values)[KeyOf(active, parameter)] = reader.Number(given, "value");
      }
    }
    std::stable_sort(effects.begin(), effects.end(), [](const auto& a, const auto& b) {
      return ActsBefore(a.effect, b.effect);
    });
  }
  const std::string problem = ProblemWith(effects);
  if (!problem.empty()) reader.Fail("effects", problem);
  return effects;
}

void ReadParameters(const Reader& reader,
                    const Json& parameters,
                    const std::map<std::string, double>& values,
                    FittedModel* fitted) {
  std::vector<std::string> keys;
  std::vector<double> variances;
  const auto read = [&](const std::string& key) {
    keys.push_back(key);
    const auto given = values.find(key);
    if (given != values.end() && parameters.is_object() && !parameters.contains(key)) {
      variances.push_back(kNotKnown);
      return given->second;
    }
    const Json& parameter = reader.Member(parameters, key);
    const double std = reader.NumberIfKnown(parameter, "std");
    variances.push_back(std * std);
    return reader.Number(parameter, "value");
  };
  ParameterVector baseline;
  for (int i = 0; i < kNumParameters; ++i) baseline[i] = read(kParameterInfo[i].name);
  if (!(baseline[kInertia] > 0.0)) {
    reader.Fail("inertia", fmt::format("is {}, expected a value above 0", baseline[kInertia]));
  }
  fitted->model = ModelFromVector(baseline);
  for (ActiveEffect& active : fitted->effects) {
    for (const EffectParameter& parameter : active.effect->info().parameters) {
      const double value = read(KeyOf(active, parameter));
      if (!(value >= parameter.lower && value <= parameter.upper)) {
        reader.Fail(
            keys.back(),
            fmt::format("is {}, expected {} to {}", value, parameter.lower, parameter.upper));
      }
      active.values.push_back(value);
    }
  }
  for (const auto& [key, value] : parameters.items()) {
    if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
    reader.Fail(key,
                fmt::format("is a parameter of no effect of this model, expected {}",
                            fmt::join(keys, ", ")));
  }
  const auto size = static_cast<Eigen::Index>(keys.size());
  fitted->covariance.setConstant(size, size, kNotKnown);
  for (Eigen::Index i = 0; i < size; ++i) fitted->covariance(i, i) = variances[i];
}

void ReadCovariance(const Reader& reader, const Json& json, FittedModel* fitted) {
  if (!json.contains("covariance")) return;
  const Json& rows = json.at("covariance");
  const Eigen::Index size = fitted->covariance.rows();
  const auto fail = [&] {
    reader.Fail("covariance", fmt::format("is not a {0} x {0} array of numbers or nulls", size));
  };
  const auto has_size = [&](const Json& list) {
    return list.is_array() && static_cast<Eigen::Index>(list.size()) == size;
  };
  if (!has_size(rows)) fail();
  for (Eigen::Index i = 0; i < size; ++i) {
    const Json& row = rows[static_cast<std::size_t>(i)];
    if (!has_size(row)) fail();
    for (Eigen::Index j = 0; j < size; ++j) {
      const Json& value = row[static_cast<std::size_t>(j)];
      if (!value.is_number() && !value.is_null()) fail();
      fitted->covariance(i, j) = value.is_null() ? kNotKnown : value.get<double>();
    }
  }
}

}  // namespace

FittedModel ParseModel(const std::string& name, std::string_view text) {
  Json json;
  const Json::parser_callback_t refuse_deep_nesting = [&](int depth, auto, const Json&) {
    if (depth > kDeepestNesting) {
      throw InputError(fmt::format(
          "{}: is nested more than {} levels deep: not a model file.", name, kDeepestNesting));
    }
    return true;
  };
  try {
    json = Json::parse(text, refuse_deep_nesting);
  } catch (const Json::exception& error) {
    throw InputError(fmt::format("{}: is not JSON: {}.", name, error.what()));
  }
  const Reader reader(name);
  const std::string schema = reader.Text(json, "schema");
  const bool is_verdict = schema == "fathom-verdict-1";
  if (schema != "fathom-model-1" && !is_verdict) {
    reader.Fail(
        "schema",
        fmt::format("is {}, expected 'fathom-model-1' or 'fathom-verdict-1'", Quoted(schema)));
  }
  const Json& model = is_verdict ? reader.Member(json, "extended") : json;
  const Json& parameters = reader.Member(model, "parameters");
  FittedModel fitted;
  const auto dof = DofFromName(reader.Text(json, "dof"));
  if (!dof) reader.Fail("dof", "is not one of surge, sway, heave, roll, pitch, yaw");
  fitted.dof = *dof;
  fitted.force_unit =
      json.contains("force_unit") ? reader.Text(json, "force_unit") : std::string(ForceUnit(*dof));
  std::map<std::string, double> values;
  fitted.effects = ReadEffects(reader, json, model, *dof, &values);
  ReadParameters(reader, parameters, values, &fitted);
  ReadCovariance(reader, model, &fitted);
  if (is_verdict) {
    fitted.train = ReadFigures(reader, json, "extended");
    fitted.held_out.nmae = reader.NumberIfKnown(model, "heldout_nmae");
  } else {
    fitted.train = ReadFigures(reader, json, "fit");
    fitted.held_out = ReadFigures(reader, json, "held_out");
  }
  fitted.log_fingerprints = reader.TextsIfThere(json, "log_fingerprints");
  fitted.logs = reader.TextsIfThere(json, "logs");
  return fitted;
}

}  // namespace fathom
