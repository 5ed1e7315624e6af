// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/log.h"

#include <filesystem>
#include <string>

namespace fathom {

// Writes a stream as CSV, each number with the fewest digits that give it back to the bit. Throws
// InputError if the file cannot be written.
void WriteStream(const std::filesystem::path& path, const Stream& stream);

// log.yaml of a log, that is all but its streams.
std::string FormatLogYaml(const Log& log);

// Writes a log folder: log.yaml and the streams there are. ReadLog gives the same log back, to the
// bit, but for its path and remarks. Throws InputError if the folder cannot be written, or holds a
// stream of another log that this one does not replace.
void WriteLog(const std::filesystem::path& folder, const Log& log);

}  // namespace fathom
