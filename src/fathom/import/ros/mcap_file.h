// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/message/message_container.h"

#include <filesystem>
#include <memory>
#include <string_view>

namespace fathom {

// Whether a file that begins with these bytes is an MCAP file.
bool LooksLikeMcap(std::string_view first_bytes);

// An MCAP file with messages of ROS 1 or ROS 2; chunks that are plain, lz4 or zstd, or none. It is
// read from its first byte to its last, so that its summary may be missing. The format:
// mcap.dev/spec.
std::unique_ptr<MessageContainer> OpenMcap(const std::filesystem::path& path);

}  // namespace fathom
