// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/numpy/zip_file.h"

#include "fathom/base/input_error.h"
#include "fathom/import/recording/inflated.h"
#include "fathom/import/recording/number_type.h"

#include <algorithm>
#include <cstddef>

#include <fmt/format.h>
#include <zlib.h>

namespace fathom {
namespace {

constexpr std::string_view kLocalMagic("PK\x03\x04", 4);
constexpr std::string_view kEntryMagic("PK\x01\x02", 4);
constexpr std::string_view kEndMagic("PK\x05\x06", 4);
constexpr std::size_t kLocalHeader = 30;  // [bytes], without the name
constexpr std::size_t kEntryHeader = 46;
constexpr std::size_t kEndRecord = 22;
constexpr std::size_t kLongestComment = 65535;
constexpr std::uint64_t kElsewhere = 0xffffffff;  // the number stands in a field of "zip64"
constexpr std::size_t kMostEntries = 100'000;

[[noreturn]] void RefuseZip(const ByteFile& file, const std::string& what) {
  throw InputError(fmt::format("{}: {}.", file.path().string(), what));
}

// The record that says where the directory stands: the last one that a comment may follow.
std::string EndRecordOf(ByteFile* file) {
  const std::uint64_t size = file->size();
  const std::uint64_t begin = size - std::min<std::uint64_t>(size, kEndRecord + kLongestComment);
  const std::string tail(file->View(begin, static_cast<std::size_t>(size - begin)));
  for (std::size_t at = tail.rfind(kEndMagic); at != std::string::npos;) {
    const bool is_whole = tail.size() - at >= kEndRecord;
    if (is_whole && at + kEndRecord + NumberAt<std::uint16_t>(tail, at + 20) <= tail.size()) {
      return tail.substr(at, kEndRecord);
    }
    at = at == 0 ? std::string::npos : tail.rfind(kEndMagic, at - 1);
  }
  RefuseZip(*file,
            "has no directory at its end, expected a whole .zip: it is cut, or still being "
            "written");
}

}  // namespace

bool LooksLikeZip(std::string_view first_bytes) {
  return first_bytes.starts_with(kLocalMagic) || first_bytes.starts_with(kEndMagic);
}

std::vector<ZipEntry> ReadZipDirectory(ByteFile* file) {
  const std::string end = EndRecordOf(file);
  const std::uint64_t size = NumberAt<std::uint32_t>(end, 12);
  std::uint64_t at = NumberAt<std::uint32_t>(end, 16);
  if (at == kElsewhere || size == kElsewhere) {
    RefuseZip(*file, "is a .zip of 4 GB or more, expected a smaller one");
  }
  if (at > file->size() || size > file->size() - at) {
    RefuseZip(*file, "its directory does not lie within it: it is damaged");
  }
  const std::uint64_t directory_end = at + size;
  std::vector<ZipEntry> entries;
  std::uint64_t packed_bytes = 0;
  while (at < directory_end) {
    const std::string header(file->View(at, kEntryHeader));
    if (header.size() < kEntryHeader || !header.starts_with(kEntryMagic)) {
      RefuseZip(*file, fmt::format("its directory is damaged at byte {}", at));
    }
    ZipEntry entry;
    entry.is_encrypted = (NumberAt<std::uint16_t>(header, 8) & 1) != 0;
    entry.method = static_cast<int>(NumberAt<std::uint16_t>(header, 10));
    entry.checksum = NumberAt<std::uint32_t>(header, 16);
    entry.packed_bytes = NumberAt<std::uint32_t>(header, 20);
    entry.whole_bytes = NumberAt<std::uint32_t>(header, 24);
    entry.header = NumberAt<std::uint32_t>(header, 42);
    const std::size_t name_size = NumberAt<std::uint16_t>(header, 28);
    entry.name = file->View(at + kEntryHeader, name_size);
    packed_bytes += entry.packed_bytes;
    if (packed_bytes > file->size() || entry.header > file->size()) {
      RefuseZip(*file,
                fmt::format("the directory states more bytes than the file has, at byte {}: it is "
                            "damaged, or of 4 GB and more",
                            at));
    }
    if (entries.size() == kMostEntries) RefuseZip(*file, "has more than 100000 entries");
    at += kEntryHeader + name_size + NumberAt<std::uint16_t>(header, 30) +
          NumberAt<std::uint16_t>(header, 32);
    entries.push_back(std::move(entry));
  }
  return entries;
}

std::optional<std::string> Unzipped(ByteFile* file, const ZipEntry& entry, std::size_t most) {
  if (entry.is_encrypted || entry.whole_bytes > most) return std::nullopt;
  const std::string local(file->View(entry.header, kLocalHeader));
  if (local.size() < kLocalHeader || !local.starts_with(kLocalMagic)) return std::nullopt;
  const std::uint64_t begin = entry.header + kLocalHeader + NumberAt<std::uint16_t>(local, 26) +
                              NumberAt<std::uint16_t>(local, 28);
  if (begin > file->size() || entry.packed_bytes > file->size() - begin) return std::nullopt;
  std::optional<std::string> bytes;
  if (entry.method == 0 && entry.packed_bytes == entry.whole_bytes) {
    bytes = file->Copy(begin, entry.packed_bytes);
  } else if (entry.method == 8) {
    bytes = Inflated(file,
                     begin,
                     entry.packed_bytes,
                     static_cast<std::size_t>(entry.whole_bytes),
                     DeflateFrame::kNone);
  }
  if (!bytes || bytes->size() != entry.whole_bytes) return std::nullopt;
  const auto checksum =
      crc32(0, reinterpret_cast<const Bytef*>(bytes->data()), static_cast<uInt>(bytes->size()));
  if (checksum != entry.checksum) return std::nullopt;
  return bytes;
}

}  // namespace fathom
