// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/suggest/autopilot_readiness.h"

#include <iterator>

#include <fmt/format.h>

namespace fathom {

void JudgeReadiness(bool has_both,
                    int num_outputs,
                    const std::optional<Vehicle>& vehicle,
                    SuggestedMap* map) {
  map->needs_vehicle = has_both && !vehicle;
  map->is_ready = has_both && vehicle && num_outputs >= std::ssize(vehicle->thrusters);
  if (!has_both || !vehicle || map->is_ready) return;
  map->text += fmt::format("# the log drives {} outputs, the vehicle has {} thrusters.\n",
                           num_outputs,
                           vehicle->thrusters.size());
}

}  // namespace fathom
