// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <random>
#include <vector>

#include "drawn_vehicle.h"

namespace fathom {

// Two thrusters ahead to each side, two abeam fore and aft.
std::vector<CommandedThruster> FourThrusters();

// DrawnLog() of a vehicle that is driven by FourThrusters(), of which `gain` tells how much of its
// command each pushes. With `holds_heading` a controller steers against every turn, so that steps
// of yaw are asked for by no one.
CoupledData DrawnThrusterLog(const CoupledModel& model,
                             const std::array<double, 4>& gain,
                             bool holds_heading,
                             const DrawnLogOptions& options,
                             std::mt19937* random);

}  // namespace fathom
