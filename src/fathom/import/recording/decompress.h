// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace fathom {

enum class Compression { kNone, kBzip2, kLz4, kZlib, kZstd };

// What this many compressed bytes unpack to at most: 1000 times as many, but 64 MiB at least and
// 1 GiB at most. A bomb, some kilobytes that promise and hold gigabytes of zeros, ends there.
std::size_t MostUnpackedOf(std::size_t num_compressed);

// The first `size` bytes at most, and no more than MostUnpackedOf(), of what was compressed; fewer
// where the data is cut or damaged. LZ4 and Zstandard as frames. They lie in `buffer`, which serves
// the next call too, or are `data` itself if it is not compressed.
std::string_view Decompressed(Compression compression,
                              std::string_view data,
                              std::size_t size,
                              std::string* buffer);

}  // namespace fathom
