// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/suggest/suggested_map.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <optional>

namespace fathom {

// The vehicle, if the log drives at least as many outputs as it has thrusters.
std::optional<Vehicle> IfDriven(const std::optional<Vehicle>& vehicle, int num_outputs);

// Ends the map of an autopilot's log: `needs_vehicle` if only that is missing, `is_ready` if the
// log drives the vehicle; else `why_not_ready` and a comment say so. `has_both`: the log has
// outputs and motion.
void JudgeReadiness(bool has_both,
                    int num_outputs,
                    const std::optional<Vehicle>& vehicle,
                    SuggestedMap* map);

}  // namespace fathom
