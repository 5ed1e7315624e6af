// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace fathom {

// A file to be written into a folder.
struct StarterFile {
  std::string name;
  std::string text;
};

// What a folder lacks to be, or to become, a log.
struct Starter {
  std::vector<StarterFile> files;     // none of which is there
  std::vector<std::string> kept;      // files that would be written were they not there
  std::vector<std::string> remarks;   // a sentence each
  std::vector<std::string> commands;  // to type next, one for each log
};

// Of a log: its log.yaml and vehicle file. Of recordings: the vehicle file, and a map for each, as
// SuggestMap() gives it, where that can be read as it is; fathom_import writes their log.yaml. Of a
// single CSV: nothing, it is a log. Throws InputError for a folder that cannot be read.
Starter StarterOf(const std::filesystem::path& folder);

}  // namespace fathom
