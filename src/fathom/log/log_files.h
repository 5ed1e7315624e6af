// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace fathom {

// The names of the files that a log in this folder consists of, whether they are there or not; not
// its images or video.
std::set<std::string> FilesOfLog(const std::filesystem::path& folder);

// Every file that decides what comes out of a log, in a fixed order: of a folder the files there
// are of those above, the vehicle file wherever it lies, the video, and with a frames.csv
// everything else in the folder, which may be images; of a single CSV itself. What is no regular
// file, as a pipe, is listed too.
std::vector<std::filesystem::path> InputFilesOf(const std::filesystem::path& log);

}  // namespace fathom
