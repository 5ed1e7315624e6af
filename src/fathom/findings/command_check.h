// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/findings/finding.h"
#include "fathom/log/held_command.h"
#include "fathom/signal/segment.h"

#include <span>
#include <string>
#include <vector>

namespace fathom {

// What the command of one DOF shows by itself and beside the motion; docs/findings.md. All are
// notes.
//
//   clipped_command   one limit holds for a tenth of the time, though other values are many
//   few_changes       fewer than four changes while the motion was measured: few parameters show
//   short_log         less than 30 s of motion
//   closed_loop       the command follows the motion: noise of the speed is in it. Second
//   differences,
//                     in which noise is large and motion small, have opposite signs at a delay of 0
//                     to 2 samples, and the same sign a sample beside it, as noise has and no
//                     smooth motion
std::vector<Finding> CheckCommand(const HeldCommand& command,
                                  std::span<const Segment> segments,
                                  const std::string& force_unit);

}  // namespace fathom
