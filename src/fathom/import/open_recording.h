// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/recording.h"
#include "fathom/import/table/table_layout.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace fathom {

// Opens a recording of any format that Fathom reads, by what its first bytes are, not by its name;
// docs/import.md. A folder is its files together (JoinRecordings()): those of the known formats,
// and of text those that are called .csv, .txt, .tsv or .dat; a remark names the others. `table`:
// how to read tables of text. Throws InputError, naming the file and the formats there are, for
// anything else.
std::unique_ptr<Recording> OpenRecording(const std::filesystem::path& path,
                                         const TableOptions& table = {});

// Whether a file begins as one of these formats, tables of text left aside. False if it cannot be
// read.
bool IsRecording(const std::filesystem::path& file);

// The files of a recording: itself, or those of the folder. Throws InputError for a folder that
// cannot be read.
std::vector<std::filesystem::path> FilesOfRecording(const std::filesystem::path& path);

// Tells one recording's files from another's: ContentOf() a file; of a folder that of its files and
// their names. Throws as ContentOf() does.
std::string ContentOfRecording(const std::filesystem::path& path);

}  // namespace fathom
