// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/recording.h"

#include <filesystem>
#include <memory>
#include <string_view>

namespace fathom {

// Whether a file that begins with these bytes is a PX4 log (.ulg).
bool LooksLikeUlog(std::string_view first_bytes);

// A PX4 log (ULog); docs/import.md. A channel is a topic, and each further instance of it one more:
// "battery_status", "battery_status[1]". Stamps are the field `timestamp`, in seconds since the
// autopilot started. Numbers are as they stand: the format states no units.
//
// A log that is cut, or damaged, is read as far as it is sound. Throws InputError for a file
// without data, and for one whose flags forbid to read it.
std::unique_ptr<Recording> OpenUlog(const std::filesystem::path& path);

}  // namespace fathom
