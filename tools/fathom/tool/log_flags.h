// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/log/log.h"
#include "fathom/log/read_log.h"
#include "fathom/tool/flag_values.h"

#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <gflags/gflags_declare.h>

// Flags of every tool that reads logs.
DECLARE_string(log);
DECLARE_string(velocity);

namespace fathom {

// The paths that --log names, one or several: repeated, or with commas between them where there is
// no file or folder of the whole name. Throws InputError if two are the same place: the same
// data twice would count as twice as much.
std::vector<std::string> LogPathsFromFlags();

// What the tool reads: these paths, and the file of --velocity where it is given.
std::vector<std::string> InputsFromFlags();

// The flags of these that are given, as a proposed command takes them: " --correct=p:-1". They say
// which data are read, so that the command reads the same.
std::string GivenFlags(std::initializer_list<const char*> names);

// Throws InputError if two logs hold the same data, whatever their names.
void RequireDifferentData(const std::vector<Log>& logs);

// Throws InputError if --held_out leaves no sample of the motion of any log to train on.
void RequireTrainingData(std::span<const Log> logs);

// OpenLog() of every path of --log (with --velocity, --held_out and --correct); prints the remarks
// to stderr, of several logs with their paths. Throws InputError if two hold the same data,
// whatever their names (a copy, or a log and what fathom_track made of it), or if there are several
// and
// --velocity, which belongs to one; and where they need motion, as RequireTrainingData() does.
std::vector<Log> ReadLogsFromFlags(std::optional<Dof> dof,
                                   bool may_lack_motion = false,
                                   bool may_lack_command = false);

// The same for a model of several DOFs, without the remark that one of one DOF has no fins.
std::vector<Log> ReadCoupledLogsFromFlags(bool may_lack_motion = false);

// Makes the source `camera` of a log that holds detections but no poses, and prints what was lost
// on the way to stderr. Throws InputError as TrackDetections does.
void AddCameraSource(Log* log);

// The same where the log can do without: a calibration that is missing or cannot be used only costs
// this source, and is told in the log's remarks and on stderr.
void AddCameraSourceIfUsable(Log* log);

}  // namespace fathom
