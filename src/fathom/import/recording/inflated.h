// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/byte_file.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace fathom {

// What stands around compressed bytes: the header and checksum of zlib, or nothing, as in a .zip.
enum class DeflateFrame { kZlib, kNone };

// What the `count` bytes from `offset` on were compressed from. Nothing where they are
// damaged, or where more than `most` bytes come out.
std::optional<std::string> Inflated(ByteFile* file,
                                    std::uint64_t offset,
                                    std::uint64_t count,
                                    std::size_t most,
                                    DeflateFrame frame = DeflateFrame::kZlib);

// Of how many bytes `data` was compressed; nothing where it is damaged, or where they are more than
// `most`.
std::optional<std::size_t> InflatedSize(std::string_view data, std::size_t most);

}  // namespace fathom
