// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/planning/experiment_plan.h"
#include "fathom/planning/plan_limits.h"

#include <vector>

// Parts of plan.json that plans of one DOF and of several share. `Json`: nlohmann::ordered_json.

namespace fathom {

// No limit and not known are both null.
template <typename Json>
Json JsonOfRange(const ValueRange& range) {
  return Json::array({range.low, range.high});
}

// Each parameter by its name.
template <typename Json>
Json JsonOfParameters(const std::vector<PlannedParameter>& parameters) {
  Json json = Json::object();
  for (const PlannedParameter& parameter : parameters) {
    json[parameter.name] = {{"value", parameter.value},
                            {"std_before", parameter.before},
                            {"std_after", parameter.after},
                            {"std_with_log_so_far", parameter.with_log_so_far},
                            {"std_after_sine", parameter.sine},
                            {"unit", parameter.unit}};
  }
  return json;
}

// Each pair of causes.
template <typename Json>
Json JsonOfSeparations(const std::vector<PlannedSeparation>& separations) {
  Json list = Json::array();
  for (const PlannedSeparation& separation : separations) {
    list.push_back({{"truth", separation.truth},
                    {"assumed", separation.assumed},
                    {"sigmas", separation.sigmas},
                    {"sigmas_of_sine", separation.sine},
                    {"sigmas_with_positions", separation.with_positions}});
  }
  return list;
}

}  // namespace fathom
