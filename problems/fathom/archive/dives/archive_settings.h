// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace fathom {

// How recordings become logs.
struct ArchiveImport {
  std::string files = {};              // a pattern of paths as a shell has it
  std::filesystem::path map = {};      // a map file; empty: the one that the format makes sure of
  std::filesystem::path vehicle = {};  // a vehicle file; empty: the map's, or none
};

// What archive.yaml says about an archive; docs/archive.md. All of it may be missing.
struct ArchiveSettings {
  std::optional<int> dive_level = {};  // which folder of a log's path names its dive, from 1 on
  std::string dive_pattern = {};       // a regular expression: its first match in the path does
  std::filesystem::path vehicle = {};  // a vehicle file; empty: none
  std::string vehicle_name = {};       // as `vehicle:` stands there
  std::optional<Dof> dof = {};         // of logs that are a single CSV
  std::vector<std::string> leave_out = {};  // patterns of paths as a shell has them
  std::vector<ArchiveImport> imports = {};  // the first that fits a path holds
};

// Reads `archive`/archive.yaml; the defaults if there is none. Throws InputError, naming file, line
// and key, for whatever breaks the format.
ArchiveSettings ReadArchiveSettings(const std::filesystem::path& archive);

// The same of the text of a file with this name.
ArchiveSettings ParseArchiveSettings(const std::filesystem::path& name, const std::string& text);

// The dive of a log by its path from the archive on: the match of the pattern, or the folder at the
// level, or without either the folder that the log lies in. A log that lies in the archive itself
// is a dive of its own.
std::string DiveOfPath(const std::filesystem::path& path, const ArchiveSettings& settings);

// The import whose pattern a path from the archive on matches; null if there is none.
const ArchiveImport* ImportOf(const std::string& path, const ArchiveSettings& settings);

// Whether a path from the archive on matches one of `leave_out`.
bool IsLeftOut(const std::string& path, const ArchiveSettings& settings);

}  // namespace fathom
