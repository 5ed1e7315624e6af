// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/log/held_command.h"
#include "fathom/log/log.h"
#include "fathom/signal/sources/source.h"

#include <string>
#include <vector>

namespace fathom {

// The file of a log as messages name it: of a single CSV that file, else `file` in the folder.
std::string FileOf(const Log& log, const char* file);

// The file that the poses come from: pose.csv, or detections.csv where they were made from it.
std::string PoseFileOf(const Log& log);

// The command of one DOF. Throws InputError, saying what the log has instead, if there is none.
HeldCommand CommandOf(const Log& log, Dof dof);

// The unit of the commands along one DOF: the log's command_unit, or "N" or "N m".
std::string CommandUnitOf(const Log& log, Dof dof);

// What to say of a command that ends more than `longest_gap` [s] before the motion at `time`; empty
// if it does not.
std::string RemarkOnEarlyEnd(const HeldCommand& command,
                             const std::vector<double>& time,
                             double longest_gap);

// The stream that holds the motion. Throws InputError, saying what the log has instead, if it or
// the DOF's column is missing.
const Stream& MotionStream(const Log& log, Dof dof, Source source);

}  // namespace fathom
