// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/recording.h"

#include <filesystem>
#include <memory>
#include <string_view>

namespace fathom {

// Whether a file that begins with these bytes is a telemetry log of a ground station (.tlog).
bool LooksLikeTlog(std::string_view first_bytes);

// What a ground station heard (MAVLink packets, each with its time); docs/import.md. A channel is a
// message, "ATTITUDE", or where several senders send it, one of them: "ATTITUDE (1/1)", by system
// and component. Stamps are the ground station's, in seconds since 1970. Numbers are as they stand,
// in the units that MAVLink states. Messages that the reader does not know are counted.
//
// A log that is cut, or damaged, is read as far as it is sound. Throws InputError for a file
// without a message that the reader knows.
std::unique_ptr<Recording> OpenTlog(const std::filesystem::path& path);

}  // namespace fathom
