// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/byte_file.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// A file within a .zip, as its directory tells.
struct ZipEntry {
  std::string name;
  std::uint64_t header = 0;        // where its own header stands
  std::uint64_t packed_bytes = 0;  // in the .zip
  std::uint64_t whole_bytes = 0;   // unpacked
  std::uint32_t checksum = 0;      // CRC-32 of the unpacked bytes
  int method = 0;                  // 0: stored, 8: deflate
  bool is_encrypted = false;
};

bool LooksLikeZip(std::string_view first_bytes);

// The directory at the end of a .zip (PKWARE's APPNOTE.TXT, 4.3.12 and 4.3.16). Entries that would
// lie within each other are not possible: together they have no more bytes than the file, so that
// all of them unpack to 1032 times its size at most. Throws InputError, which names the file, for a
// .zip without a directory, of 4 GB and more, or with more than 100000 entries.
std::vector<ZipEntry> ReadZipDirectory(ByteFile* file);

// The bytes of an entry. Nothing where they are damaged, of another method, encrypted or more than
// `most`.
std::optional<std::string> Unzipped(ByteFile* file, const ZipEntry& entry, std::size_t most);

}  // namespace fathom
