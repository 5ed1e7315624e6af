// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/recording.h"

#include <filesystem>
#include <string>

namespace fathom {

// "dive.BIN: dataflash, 288 kB, 39 channels, 402 fields"
std::string Heading(const std::filesystem::path& file, const Contents& contents);

// That, a table of the channels and what the recording remarks; all fields with --wide.
void PrintContents(const std::filesystem::path& file, const Contents& contents);

}  // namespace fathom
