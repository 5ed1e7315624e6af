// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/numpy/zip_file.h"

#include "fathom/base/input_error.h"
#include "fathom/import/recording/inflated.h"

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

std::uint32_t ZipNumber(std::string_view bytes, std::size_t offset, std::size_t size) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < size; ++i) {
    number |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[offset + i])) << (8 * i);
  }
  return number;
}

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
    if (is_whole && at + kEndRecord + ZipNumber(tail, at + 20, 2) <= tail.size()) {
      return tail.substr(at, kEndRecord);
    }
    at = at == 0 ? std::string::npos : tail.rfind(kEndMagic, at - 1);
  }
  RefuseZip(*file,
            "has no directory at its end, expected a whole .zip: it is cut, or still being "
            "written");
}

std::optional<std::string> Stored(ByteFile* file, std::uint64_t at, std::uint64_t size) {
  std::string bytes;
  bytes.reserve(static_cast<std::size_t>(size));
  while (bytes.size() < size) {
    constexpr std::size_t kStep = std::size_t{1} << 20;
    const auto left = static_cast<std::size_t>(size - bytes.size());
    const std::string_view next = file->View(at + bytes.size(), std::min(kStep, left));
    if (next.empty()) return std::nullopt;
    bytes.append(next);
  }
  return bytes;
}

}  // namespace

bool LooksLikeZip(std::string_view first_bytes) {
  return first_bytes.starts_with(kLocalMagic) || first_bytes.starts_with(kEndMagic);
}

std::vector<ZipEntry> ReadZipDirectory(ByteFile* file) {
  const std::string end = EndRecordOf(file);
  const std::uint64_t size = ZipNumber(end, 12, 4);
  std::uint64_t at = ZipNumber(end, 16, 4);
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
    entry.is_encrypted = (ZipNumber(header, 8, 2) & 1) != 0;
    entry.method = static_cast<int>(ZipNumber(header, 10, 2));
    entry.checksum = ZipNumber(header, 16, 4);
    entry.packed_bytes = ZipNumber(header, 20, 4);
    entry.whole_bytes = ZipNumber(header, 24, 4);
    entry.header = ZipNumber(header, 42, 4);
    const std::size_t name_size = ZipNumber(header, 28, 2);
    entry.name = file->View(at + kEntryHeader, name_size);
    packed_bytes += entry.packed_bytes;
    if (packed_bytes > file->size() || entry.header > file->size()) {
      RefuseZip(*file,
                fmt::format("the directory states more bytes than the file has, at byte {}: it is "
                            "damaged, or of 4 GB and more",
                            at));
    }
    if (entries.size() == kMostEntries) RefuseZip(*file, "has more than 100000 entries");
    at += kEntryHeader + name_size + ZipNumber(header, 30, 2) + ZipNumber(header, 32, 2);
    entries.push_back(std::move(entry));
  }
  return entries;
}

std::optional<std::string> Unzipped(ByteFile* file, const ZipEntry& entry, std::size_t most) {
  if (entry.is_encrypted || entry.whole_bytes > most) return std::nullopt;
  const std::string local(file->View(entry.header, kLocalHeader));
  if (local.size() < kLocalHeader || !local.starts_with(kLocalMagic)) return std::nullopt;
  const std::uint64_t begin =
      entry.header + kLocalHeader + ZipNumber(local, 26, 2) + ZipNumber(local, 28, 2);
  if (begin > file->size() || entry.packed_bytes > file->size() - begin) return std::nullopt;
  std::optional<std::string> bytes;
  if (entry.method == 0 && entry.packed_bytes == entry.whole_bytes) {
    bytes = Stored(file, begin, entry.packed_bytes);
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
