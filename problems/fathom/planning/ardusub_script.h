// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/planning/experiment_plan.h"
#include "fathom/planning/thruster_allocation.h"

#include <string>

namespace fathom {

// Whether ArduSub has as many motors as the vehicle thrusters, and each has pulse widths.
bool HasArduSubScript(const ThrusterAllocation& thrusters);

// A Lua script that ArduSub runs: it plays the pulse widths of a plan, thruster k by the output of
// motor k, and ends at neutral. docs/plan.md, "On ArduSub". Only where HasArduSubScript().
std::string FormatArduSubScript(Dof dof,
                                const ExperimentPlan& plan,
                                const ThrusterAllocation& thrusters);

}  // namespace fathom
