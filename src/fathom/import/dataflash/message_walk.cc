// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/dataflash/message_walk.h"

#include <algorithm>
#include <cstddef>

namespace fathom {
namespace {

constexpr std::size_t kMessageHeader = 3;
constexpr std::size_t kReadChunk = 1 << 16;  // [bytes]

// The format of the message whose header `bytes` begins with; null if it begins none.
const MessageFormat* FormatAt(std::string_view bytes, const MessageFormats& formats) {
  if (bytes.size() < kMessageHeader || bytes[0] != '\xa3' || bytes[1] != '\x95') return nullptr;
  const MessageFormat& format = formats[static_cast<unsigned char>(bytes[2])];
  return format.type < 0 ? nullptr : &format;
}

// The first place from `offset` on that holds `byte`, or does not where `is_same` is false; the end
// of the file if there is none.
std::uint64_t FindFrom(ByteFile* file, std::uint64_t offset, char byte, bool is_same) {
  while (offset < file->size()) {
    const std::string_view chunk = file->View(offset, kReadChunk);
    const std::size_t found = is_same ? chunk.find(byte) : chunk.find_first_not_of(byte);
    if (found != std::string_view::npos) return offset + found;
    offset += chunk.size();
  }
  return file->size();
}

// Whether `bytes` begin as every message does, of a known type or not.
bool BeginsMessage(std::string_view bytes) { return bytes.starts_with("\xa3\x95"); }

// Whether the message at `offset` is whole and another one, or the end of the file, follows it.
bool IsFollowed(ByteFile* file, std::uint64_t offset, const MessageFormat& format) {
  const std::string_view bytes = file->View(offset, format.length + kMessageHeader);
  if (bytes.size() < format.length) return false;
  const std::string_view behind = bytes.substr(format.length);
  return behind.empty() || BeginsMessage(behind);
}

// Where within the message at `offset`, which none follows, another begins that one follows: a
// writer that lost bytes goes on there. 0 if there is no such place.
std::uint64_t NextWithin(ByteFile* file,
                         std::uint64_t offset,
                         const MessageFormat& format,
                         const MessageFormats& formats) {
  for (std::uint64_t at = offset + kMessageHeader; at < offset + format.length; ++at) {
    const MessageFormat* inner = FormatAt(file->View(at, kMessageHeader), formats);
    if (inner != nullptr && IsFollowed(file, at, *inner)) return at;
  }
  return 0;
}

}  // namespace

MessageWalk ForEachMessage(
    ByteFile* file,
    const MessageFormats& formats,
    const std::function<void(const MessageFormat& format, std::string_view message)>& take) {
  MessageWalk walk;
  const auto skip_to = [&](std::uint64_t from, std::uint64_t to) {
    if (walk.skipped_bytes == 0) walk.first_skipped = from;
    walk.skipped_bytes += to - from;
  };
  std::uint64_t at = 0;
  bool is_aligned = true;
  while (at < file->size()) {
    const MessageFormat* format = FormatAt(file->View(at, kMessageHeader), formats);
    if (format != nullptr) {
      const bool is_whole = format->length <= file->size() - at;
      const bool is_followed = IsFollowed(file, at, *format);
      const std::uint64_t next = is_followed ? 0 : NextWithin(file, at, *format, formats);
      if (next != 0) {
        skip_to(at, next);
        at = next;
        continue;
      }
      if (is_aligned && !is_whole) {
        walk.cut_bytes = file->size() - at;
        walk.cut_message = format->name;
        return walk;
      }
      if (is_followed || (is_aligned && is_whole)) {
        const std::size_t length = format->length;
        take(*format, file->View(at, length));
        at += length;
        is_aligned = is_followed;
        continue;
      }
    }
    // Not the start of a message.
    is_aligned = false;
    const std::uint64_t behind_zeros = FindFrom(file, at, '\0', /*is_same=*/false);
    if (behind_zeros == file->size()) {
      walk.padding_bytes = file->size() - at;
      return walk;
    }
    const std::uint64_t next = FindFrom(file, std::max(at + 1, behind_zeros), '\xa3', true);
    skip_to(at, next);
    at = next;
  }
  return walk;
}

MessageFormats ReadFormats(ByteFile* file, int* num_redefined) {
  MessageFormats formats;
  formats[kFmtType] = FormatOfFmt();
  *num_redefined = 0;
  // Each new format lets the walk step over the messages that follow it, so that it soon finds its
  // way from message to message.
  ForEachMessage(file, formats, [&](const MessageFormat& format, std::string_view message) {
    if (format.type != kFmtType) return;
    const MessageFormat defined = ParseFmt(message);
    if (defined.type < 0 || defined.type == kFmtType) return;
    MessageFormat& known = formats[defined.type];
    if (known.type < 0) {
      known = defined;
    } else if (known.length != defined.length || known.name != defined.name ||
               known.columns != defined.columns) {
      ++*num_redefined;
    }
  });
  return formats;
}

}  // namespace fathom
