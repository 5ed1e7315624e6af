// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/base/input_error.h"
#include "fathom/log/log.h"
#include "fathom/log/read_log.h"

#include <optional>
#include <string>
#include <vector>

#include <gflags/gflags_declare.h>

// Flags of every tool that reads logs.
DECLARE_string(log);
DECLARE_string(velocity);

namespace fathom {

// Splits at commas; empty for an empty text.
std::vector<std::string> SplitAtCommas(const std::string& text);

// parse(text), with the flag's name before what it says of a text it cannot use.
template <typename Parse>
auto ParseFlag(const std::string& flag, const std::string& text, Parse parse) {
  try {
    return parse(text);
  } catch (const InputError& error) {
    throw InputError("--" + flag + ": " + error.what());
  }
}

// The paths that --log names, one or several. Throws InputError if two are the same place: the same
// data twice would count as twice as much.
std::vector<std::string> LogPathsFromFlags();

// What the tool reads: these paths, and the file of --velocity where it is given.
std::vector<std::string> InputsFromFlags();

// Reads --log (with --velocity), turning thruster speeds into forces where the log's vehicle file
// says how, and prints the reader's remarks to stderr. Of a log whose only motion is detections the
// poses are made (AddCameraSource).
// `may_lack_motion` as in ReadLogOptions; detections then stay what they are.
Log ReadLogFromFlags(const std::string& path, std::optional<Dof> dof, bool may_lack_motion = false);

// The same of every log that --log names. Throws InputError if two hold the same data, whatever
// their names (a copy, or a log and what fathom_track made of it), or if there are several and
// --velocity, which belongs to one.
std::vector<Log> ReadLogsFromFlags(std::optional<Dof> dof, bool may_lack_motion = false);

// Makes the source `camera` of a log that holds detections but no poses, and prints what was lost
// on the way to stderr. Throws InputError as TrackDetections does.
void AddCameraSource(Log* log);

// The same where the log can do without: a calibration that is missing or cannot be used only costs
// this source, and is told in the log's remarks and on stderr.
void AddCameraSourceIfUsable(Log* log);

}  // namespace fathom
