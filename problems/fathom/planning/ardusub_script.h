// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/planning/thruster_set.h"

#include <string>
#include <string_view>

namespace fathom {

// Whether ArduSub has as many motors as the vehicle thrusters, and each has pulse widths.
bool HasArduSubScript(const ThrusterSet& thrusters);

// A Lua script that ArduSub runs: it plays the pulse widths of a plan, thruster k by the output of
// motor k, and ends at neutral. docs/plan.md, "On ArduSub". `what`: is driven, "surge". Only
// where HasArduSubScript().
std::string FormatArduSubScript(std::string_view what,
                                const PlannedThrusts& plan,
                                const ThrusterSet& thrusters);

}  // namespace fathom
