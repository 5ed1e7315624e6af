// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/comparison/comparison_file.h"

#include "fathom/base/files/json_text.h"
#include "fathom/comparison/recommendation.h"
#include "fathom/findings/finding_json.h"

#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using Json = nlohmann::ordered_json;

Json FormatRow(const Identification& row) {
  const FittedModel& fitted = row.fitted;
  Json parameters = Json::object();
  const ParameterVector values = ToVector(fitted.model);
  for (int i = 0; i < kNumParameters; ++i) {
    parameters[kParameterInfo[i].name] = {
        {"value", row.is_usable ? values[i] : std::numeric_limits<double>::quiet_NaN()},
        {"std", std::sqrt(fitted.covariance(i, i))},
        {"unit", ParameterUnit(i, fitted.dof, fitted.force_unit)}};
  }
  Json json = {{"dof", Name(fitted.dof)},
               {"family", Name(row.family)},
               {"source", Name(row.source)},
               {"parameters", parameters},
               {"mae", fitted.train.mae},
               {"nmae", fitted.train.nmae},
               {"heldout_mae", fitted.held_out.mae},
               {"heldout_nmae", fitted.held_out.nmae},
               {"usable", row.is_usable},
               {"message", row.message},
               {"caveats", fitted.caveats}};
  if (!row.weighting.empty()) {
    json["weighting"] = row.weighting;
    json["weighting_reason"] = row.weighting_reason;
  }
  return json;
}

}  // namespace

std::string FormatComparison(const Comparison& comparison) {
  Json rows = Json::array(), findings = Json::array(), noise = Json::object();
  for (const DofComparison& dof : comparison.dofs) {
    noise[Name(dof.dof)] = NoiseNmae(dof);
    for (const Identification& row : dof.rows) rows.push_back(FormatRow(row));
    for (Json& finding : JsonOf<Json>(dof.findings)) {
      Json of_dof = {{"dof", Name(dof.dof)}};
      of_dof.update(finding);
      findings.push_back(std::move(of_dof));
    }
  }
  const Json json = {{"schema", "fathom-comparison-1"},
                     {"log", comparison.log_name},
                     {"noise_nmae", noise},
                     {"rows", rows},
                     {"findings", findings}};
  return JsonText(json);
}

}  // namespace fathom
