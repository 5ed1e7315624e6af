// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/planning/experiment_plan.h"
#include "fathom/planning/thruster_allocation.h"

#include <string>

namespace fathom {

// thrusters.csv: t, then thruster_1 ... [N], as the command.csv of a log whose log.yaml says
// `thruster_unit: N`. A thrust holds until the next row.
std::string FormatPlannedThrusts(const ExperimentPlan& plan, const ThrusterAllocation& thrusters);

// pulses.csv: t, then thruster_1 ... [us], whole microseconds. The thrusters must have pulse
// widths.
std::string FormatPlannedPulses(const ExperimentPlan& plan, const ThrusterAllocation& thrusters);

}  // namespace fathom
