// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/suggest/autopilot_readiness.h"

#include "fathom/base/plural.h"

#include <iterator>

#include <fmt/format.h>

namespace fathom {

std::optional<Vehicle> IfDriven(const std::optional<Vehicle>& vehicle, int num_outputs) {
  return vehicle && num_outputs >= std::ssize(vehicle->thrusters) ? vehicle : std::nullopt;
}

void JudgeReadiness(bool has_both,
                    int num_outputs,
                    const std::optional<Vehicle>& vehicle,
                    SuggestedMap* map) {
  map->needs_vehicle = has_both && !vehicle;
  map->is_ready = has_both && IfDriven(vehicle, num_outputs);
  if (!has_both || !vehicle || map->is_ready) return;
  map->why_not_ready = fmt::format("the log drives {} outputs, and the vehicle '{}' has {}",
                                   num_outputs,
                                   vehicle->name,
                                   Plural(vehicle->thrusters.size(), "thruster"));
  map->text += fmt::format("# {}: this map cannot be imported with it.\n", map->why_not_ready);
}

}  // namespace fathom
