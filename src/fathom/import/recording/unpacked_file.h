// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/recording.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <string_view>

namespace fathom {

// Whether these bytes begin a Zstandard frame.
bool LooksLikeZstd(std::string_view first_bytes);

// A recording that was compressed by zstd as a whole, as `ros2 bag record --compression-mode file`
// does: unpacked into the system's folder of temporary files for as long as it is open. `open`
// opens the unpacked file; what it throws names `path`. Throws InputError for a file that is cut,
// or that unpacks to over 1000 times its bytes (and 64 MiB), or to over 64 GiB.
std::unique_ptr<Recording> OpenUnpacked(
    const std::filesystem::path& path,
    const std::function<std::unique_ptr<Recording>(const std::filesystem::path&)>& open);

}  // namespace fathom
