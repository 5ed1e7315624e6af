// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/named_parameters.h"

#include "fathom/vehicle/files/model_file.h"
#include "fathom/vehicle/parameters.h"

namespace fathom {

std::vector<PlannedParameter> NamedParameters(const FittedModel& model) {
  std::vector<PlannedParameter> parameters;
  const ParameterVector values = ToVector(model.model);
  for (int i = 0; i < kNumParameters; ++i) {
    parameters.push_back({.name = kParameterInfo[i].name,
                          .unit = ParameterUnit(i, model.dof, model.force_unit),
                          .value = values[i]});
  }
  for (const ActiveEffect& active : model.effects) {
    for (std::size_t k = 0; k < active.values.size(); ++k) {
      const EffectParameter& parameter = active.effect->info().parameters[k];
      parameters.push_back({.name = KeyOf(active, parameter),
                            .unit = UnitOf(parameter.quantity, model.dof, model.force_unit),
                            .value = active.values[k]});
    }
  }
  return parameters;
}

}  // namespace fathom
