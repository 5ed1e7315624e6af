// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/model_file.h"

#include "fathom/base/input_error.h"
#include "fathom/base/input_file.h"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kDeepestNesting = 16;
constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();

Json FormatFigures(const FitFigures& figures) {
  return {{"mae", figures.mae},
          {"nmae", figures.nmae},
          {"n", figures.num_samples},
          {"duration", figures.duration}};
}

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
    if (!value.is_string()) Fail(key, fmt::format("is {}, expected a text", value.dump()));
    return value.get<std::string>();
  }

  double Number(const Json& object, const std::string& key) const {
    const Json& value = Member(object, key);
    if (!value.is_number() || !std::isfinite(value.get<double>())) {
      Fail(key, fmt::format("is {}, expected a finite number", Shortened(value)));
    }
    return value.get<double>();
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

void ReadParameters(const Reader& reader, const Json& parameters, FittedModel* fitted) {
  ParameterVector values;
  for (int i = 0; i < kNumParameters; ++i) {
    const ParameterInfo& info = kParameterInfo[i];
    const Json& parameter = reader.Member(parameters, info.name);
    values[i] = reader.Number(parameter, "value");
    const double std = reader.NumberIfKnown(parameter, "std");
    fitted->covariance(i, i) = std * std;
  }
  if (!(values[kInertia] > 0.0)) {
    reader.Fail("inertia", fmt::format("is {}, expected a value above 0", values[kInertia]));
  }
  for (const auto& [key, value] : parameters.items()) {
    bool known = false;
    for (const ParameterInfo& info : kParameterInfo) known = known || key == info.name;
    if (!known) reader.Fail(key, "is a parameter of an effect that this version cannot simulate");
  }
  fitted->model = ModelFromVector(values);
}

void ReadCovariance(const Reader& reader, const Json& json, FittedModel* fitted) {
  if (!json.contains("covariance")) return;
  const Json& rows = json.at("covariance");
  const auto fail = [&] { reader.Fail("covariance", "is not a 4 x 4 array of numbers or nulls"); };
  if (!rows.is_array() || rows.size() != kNumParameters) fail();
  for (int i = 0; i < kNumParameters; ++i) {
    if (!rows[i].is_array() || rows[i].size() != kNumParameters) fail();
    for (int j = 0; j < kNumParameters; ++j) {
      if (!rows[i][j].is_number() && !rows[i][j].is_null()) fail();
      fitted->covariance(i, j) = rows[i][j].is_null() ? kNotKnown : rows[i][j].get<double>();
    }
  }
}

}  // namespace

std::string FormatModel(const FittedModel& fitted) {
  Json parameters = Json::object(), covariance = Json::array();
  const ParameterVector values = ToVector(fitted.model);
  for (int i = 0; i < kNumParameters; ++i) {
    parameters[kParameterInfo[i].name] = {
        {"value", values[i]},
        {"std", std::sqrt(fitted.covariance(i, i))},
        {"unit", ParameterUnit(i, fitted.dof, fitted.force_unit)}};
    Json row = Json::array();
    for (int j = 0; j < kNumParameters; ++j) row.push_back(fitted.covariance(i, j));
    covariance.push_back(row);
  }
  const Json json = {{"schema", "fathom-model-1"},
                     {"dof", Name(fitted.dof)},
                     {"structure", {{"baseline", "uncoupled"}, {"effects", Json::array()}}},
                     {"force_unit", fitted.force_unit},
                     {"parameters", parameters},
                     {"covariance", covariance},
                     {"fit", FormatFigures(fitted.train)},
                     {"held_out", FormatFigures(fitted.held_out)},
                     {"caveats", fitted.caveats},
                     {"provenance", fitted.provenance}};
  return json.dump(2) + "\n";
}

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
  FittedModel fitted;
  const Json* parameters = nullptr;
  if (schema == "fathom-model-1") {
    parameters = &reader.Member(json, "parameters");
  } else if (schema == "fathom-verdict-1") {
    parameters = &reader.Member(reader.Member(json, "extended"), "parameters");
  } else {
    reader.Fail("schema",
                fmt::format("is '{}', expected 'fathom-model-1' or 'fathom-verdict-1'", schema));
  }
  const auto dof = DofFromName(reader.Text(json, "dof"));
  if (!dof) reader.Fail("dof", "is not one of surge, sway, heave, roll, pitch, yaw");
  fitted.dof = *dof;
  fitted.force_unit =
      json.contains("force_unit") ? reader.Text(json, "force_unit") : std::string(ForceUnit(*dof));
  ReadParameters(reader, *parameters, &fitted);
  ReadCovariance(reader, json, &fitted);
  fitted.train = ReadFigures(reader, json, "fit");
  fitted.held_out = ReadFigures(reader, json, "held_out");
  return fitted;
}

FittedModel ReadModel(const std::filesystem::path& path) {
  return ParseModel(path.string(), ReadFile(path));
}

}  // namespace fathom
