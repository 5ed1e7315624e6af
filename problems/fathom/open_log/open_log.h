// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/log.h"
#include "fathom/log/log_text.h"
#include "fathom/log/read_log.h"

#include <filesystem>

namespace fathom {

// A log as every program takes it: ReadLog(), thruster speeds turned into forces by the vehicle
// file that log.yaml names, the mass from there unless log.yaml has it, and the poses of a log
// whose only motion is detections (TrackDetections); with `may_lack_motion` detections stay what
// they are. What was passed over on the way is in its remarks.
//
// `default_vehicle`: the vehicle file of a log whose log.yaml names no vehicle, or the name in that
// file. Log::vehicle then is this path. Empty: there is none.
//
// Throws InputError as these do, if thruster speeds come without a vehicle file, and if that cannot
// be read.
Log OpenLog(const std::filesystem::path& path,
            const ReadLogOptions& options = {},
            const std::filesystem::path& default_vehicle = {});

// The same of a log in memory: ParseLog() in place of ReadLog(). A vehicle file is looked for from
// text.path on.
Log OpenLogText(const LogText& text, bool may_lack_motion = false);

// TrackDetections() where the log can do without: a calibration that is missing or cannot be used
// only costs the source `camera`, and is told in the log's remarks.
void TrackDetectionsIfUsable(Log* log);

}  // namespace fathom
