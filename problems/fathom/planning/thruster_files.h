// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/planning/thruster_set.h"

#include <map>
#include <string>
#include <string_view>

namespace fathom {

// thrusters.csv: t, then thruster_1 ... [N], as the command.csv of a log whose log.yaml says
// `thruster_unit: N`. A thrust holds until the next row.
std::string FormatPlannedThrusts(const PlannedThrusts& plan);

// pulses.csv: t, then thruster_1 ... [us], whole microseconds. The thrusters must have pulse
// widths.
std::string FormatPlannedPulses(const PlannedThrusts& plan, const ThrusterSet& thrusters);

// What a plan writes of its thrusters, each by its name: thrusters.csv; pulses.csv where they have
// pulse widths; plan.lua where ArduSub can play these. `what`: is driven, "surge" or "surge, yaw".
std::map<std::string, std::string> ThrusterFiles(std::string_view what,
                                                 const PlannedThrusts& plan,
                                                 const ThrusterSet& thrusters);

}  // namespace fathom
