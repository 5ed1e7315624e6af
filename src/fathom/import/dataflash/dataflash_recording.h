// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/recording.h"

#include <filesystem>
#include <memory>
#include <string_view>

namespace fathom {

// Whether a file that begins with these bytes is an ArduPilot DataFlash log (.BIN).
bool LooksLikeDataflash(std::string_view first_bytes);

// An ArduPilot DataFlash log; docs/import.md. A channel is a type of message, or where a type has
// several instances (FMTU's '#') one of them: "BARO[0]", "BARO[1]". Stamps are seconds since the
// autopilot started. Numbers are in the units that the log states.
//
// A log that is cut, or damaged, is read as far as it is sound. Throws InputError for a file with
// no message.
std::unique_ptr<Recording> OpenDataflash(const std::filesystem::path& path);

}  // namespace fathom
