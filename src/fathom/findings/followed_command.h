// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/findings/finding.h"
#include "fathom/log/held_command.h"
#include "fathom/log/log.h"

#include <span>
#include <vector>

namespace fathom {

// Which share of a motion's variance a command explains through a first-order lag, the best of lags
// from 0.1 s to 30 s; 0 where one of them never changes. `value`: at the stamps `time` [s].
double ShareFollowed(std::span<const double> time,
                     std::span<const double> value,
                     const HeldCommand& command);

// Whether the velocity of a DOF follows the command that its column says. Warnings:
//
//   unsigned_speed    it follows the magnitude of the command and never goes back
//   unsigned_command  its magnitude follows the command, which never goes back
//   swapped_axes      it does not follow its command, and the velocity along another axis does
std::vector<Finding> CheckFollowedCommand(const Log& log, Dof dof);

}  // namespace fathom
