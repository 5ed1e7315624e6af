// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/files/model_file.h"

#include "fathom/base/files/input_file.h"
#include "fathom/base/files/json_text.h"
#include "fathom/vehicle/files/figures_entry.h"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using Json = nlohmann::ordered_json;

// With the range of the data that were fitted, where it is known.
Json FormatFit(const FittedModel& fitted) {
  Json fit = JsonOfFigures<Json>(fitted.train);
  if (fitted.residual_autoregression) {
    fit["residual_autoregression"] = *fitted.residual_autoregression;
  }
  if (fitted.range) {
    fit["speed_range"] = {fitted.range->speed.low, fitted.range->speed.high};
    fit["force_range"] = {fitted.range->force.low, fitted.range->force.high};
  }
  return fit;
}

Json FormatEffect(const ActiveEffect& active) {
  const EffectInfo& info = active.effect->info();
  Json json = {{"effect", info.name}};
  if (info.has_partner()) json["partner"] = Name(active.setting.partner);
  if (active.setting.reference_force != 1.0) {
    json["reference_force"] = active.setting.reference_force;
  }
  if (!active.setting.log.empty()) json["log"] = active.setting.log;
  return json;
}

}  // namespace

std::string KeyOf(const ActiveEffect& active, const EffectParameter& parameter) {
  return fmt::format("{}.{}", LabelOf(active.effect->info(), active.setting), parameter.name);
}

std::string FormatModel(const FittedModel& fitted) {
  Json parameters = Json::object(), covariance = Json::array(), effects = Json::array();
  Eigen::Index index = 0;
  const auto add = [&](const std::string& key, double value, const std::string& unit) {
    const double std = std::sqrt(fitted.covariance(index, index));
    parameters[key] = {{"value", value}, {"std", std}, {"unit", unit}};
    ++index;
  };
  const ParameterVector values = ToVector(fitted.model);
  for (int i = 0; i < kNumParameters; ++i) {
    add(kParameterInfo[i].name, values[i], ParameterUnit(i, fitted.dof, fitted.force_unit));
  }
  for (const ActiveEffect& active : fitted.effects) {
    effects.push_back(FormatEffect(active));
    const auto& infos = active.effect->info().parameters;
    for (std::size_t k = 0; k < infos.size(); ++k) {
      add(KeyOf(active, infos[k]),
          active.values[k],
          UnitOf(infos[k].quantity, fitted.dof, fitted.force_unit));
    }
  }
  for (Eigen::Index i = 0; i < index; ++i) {
    Json row = Json::array();
    for (Eigen::Index j = 0; j < index; ++j) row.push_back(fitted.covariance(i, j));
    covariance.push_back(row);
  }
  Json json = {{"schema", "fathom-model-1"},
               {"dof", Name(fitted.dof)},
               {"structure", {{"baseline", "uncoupled"}, {"effects", effects}}},
               {"force_unit", fitted.force_unit},
               {"parameters", parameters},
               {"covariance", covariance},
               {"fit", FormatFit(fitted)},
               {"held_out", JsonOfFigures<Json>(fitted.held_out)},
               {"caveats", fitted.caveats},
               {"provenance", fitted.provenance}};
  if (!fitted.thruster_shares.empty()) json["thruster_shares"] = fitted.thruster_shares;
  if (!fitted.logs.empty()) json["logs"] = fitted.logs;
  if (!fitted.log_fingerprints.empty()) json["log_fingerprints"] = fitted.log_fingerprints;
  return JsonText(json);
}

FittedModel ReadModel(const std::filesystem::path& path) {
  return ParseModel(path.string(), ReadFile(path));
}

}  // namespace fathom
