// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/archive/dives/archive_settings.h"
#include "fathom/archive/dives/nearly_log.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace fathom {

// What looks like a log: a folder with a log.yaml, or a CSV file whose first line names t, tau, v.
// Or a recording that a log is to be made of: a file that begins as one (IsRecording()), or a file
// or folder that archive.yaml names under `imports`.
// Texts, since there are many and a std::filesystem::path takes five times as much memory.
struct FoundLog {
  std::string place;  // to open it by
  std::string path;   // the same from the archive on; "." is the archive itself
  bool is_recording = false;
  std::string map = {};      // of a recording, to open it by; empty: the format makes sure of one
  std::string vehicle = {};  // likewise; empty: the map's, or none
};

// A place that could not be looked into.
struct UnreadablePlace {
  std::filesystem::path path;  // from the archive on
  std::string message;
};

struct FoundArchive {
  std::vector<FoundLog> logs;               // by path
  std::vector<UnreadablePlace> unreadable;  // folders
  // Everything else, counted: by the ending of the name (".bin"), or "pipe", "device", "socket",
  // "broken link", "link to a folder seen already", "left out".
  std::map<std::string, int> other_files;
  std::vector<NearlyLog> nearly_logs = {};  // folders, and files of those above
};

// Looks through a folder and all below it, links too; each folder once, so that links in a circle
// come to an end. Opens no pipe and no device, and writes nothing. Throws InputError if the archive
// itself is no folder or cannot be read.
FoundArchive WalkArchive(const std::filesystem::path& archive, const ArchiveSettings& settings);

// Throws InputError if there is no log at all and no folder that may hide one; says what is there.
void RequireAnyLog(const FoundArchive& found, const std::filesystem::path& archive);

}  // namespace fathom
