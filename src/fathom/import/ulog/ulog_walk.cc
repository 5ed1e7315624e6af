// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/ulog/ulog_walk.h"

#include "fathom/base/input_error.h"
#include "fathom/import/recording/number_type.h"

#include <algorithm>
#include <cstddef>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr std::size_t kFileHeader = 16;
constexpr std::size_t kULogHeader = 3;  // size of the payload, type
constexpr std::size_t kMostPayload = 65535;
constexpr std::size_t kFlags = 40;                             // payload of 'B'
constexpr std::size_t kULogSearchStep = std::size_t{1} << 16;  // of a search [bytes]
constexpr std::size_t kAhead = std::size_t{1} << 19;           // that a search looks at
constexpr int kChain = 3;                                      // messages that make a place sure
constexpr std::string_view kSyncMagic("\x2f\x73\x13\x20\x25\x0c\xbb\x12", 8);

bool IsLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

// The message that `bytes` begin with; they hold its header.
struct UlogStart {
  std::size_t size = 0;  // of the payload
  char type = 0;
};

UlogStart StartOf(std::string_view bytes) { return {NumberAt<std::uint16_t>(bytes, 0), bytes[2]}; }

bool IsKnown(char type) {
  return std::string_view("BFIMPQARDLCSO").find(type) != std::string_view::npos;
}

// Whether a message of a type can have so many bytes. Of types that are not known, any.
bool IsSize(char type, std::size_t size) {
  const auto is_one_of = [&](std::string_view types) {
    return types.find(type) != std::string_view::npos;
  };
  if (is_one_of("RO")) return size == 2;
  if (type == 'S') return size == kSyncMagic.size();
  if (type == 'B') return size >= kFlags;
  if (type == 'D') return size >= 3;
  if (is_one_of("IPA")) return size >= 4;
  if (is_one_of("FMQ")) return size >= 5;
  if (is_one_of("LC")) return size >= (type == 'L' ? 9 : 11);
  return IsLetter(type) && size > 0;
}

bool IsPrintable(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

// "\x08float piX...": the length of a key, and the key: a type and a name.
bool IsKeyed(std::string_view payload) {
  const auto length = static_cast<unsigned char>(payload[0]);
  if (length < 3 || length >= payload.size()) return false;
  const std::string_view key = payload.substr(1, length);
  return IsLetter(key[0]) && IsPrintable(key) && key.find(' ') != std::string_view::npos;
}

// The level of a text, and how it begins: words, in any language.
bool IsText(char level, std::string_view text) {
  const std::string_view beginning = text.substr(0, 16);
  return level >= '0' && level <= '7' &&
         std::all_of(beginning.begin(), beginning.end(), [](char c) {
           const auto byte = static_cast<unsigned char>(c);
           return byte >= 32 || c == '\n' || c == '\t';
         });
}

// Walks through one file. What it learns of the subscriptions helps to tell messages from other
// bytes.
class UlogWalker {
 public:
  UlogWalker(ByteFile* file, const std::function<void(char, std::string_view)>& take)
      : file_(file), take_(take), sizes_(kMostPayload + 1, kNoSubscription) {}

  void WalkSection(std::uint64_t begin, std::uint64_t end);

  const UlogWalk& walk() const { return walk_; }

 private:
  static constexpr int kNoSubscription = -1;
  static constexpr int kAnySize = 0;

  std::string_view View(std::uint64_t at, std::size_t count, std::uint64_t end) {
    return file_->View(at, static_cast<std::size_t>(std::min<std::uint64_t>(count, end - at)));
  }

  // Whether a message may begin here, where the one before it ends.
  bool MayBegin(std::string_view bytes) const;

  // Whether these bytes look as a message, wherever they stand.
  bool LooksLikeMessage(std::string_view bytes) const;

  // Whether messages follow each other here. `is_end`: the section ends where the bytes do.
  bool IsChain(std::string_view bytes, bool is_end) const;

  // The first place in [from, to) where messages follow each other; `to` if there is none.
  std::uint64_t FindChain(std::uint64_t from, std::uint64_t to, std::uint64_t end);

  bool IsZeroTo(std::uint64_t at, std::uint64_t end);

  void Skip(std::uint64_t from, std::uint64_t to) {
    if (walk_.skipped_bytes == 0) walk_.first_skipped = from;
    walk_.skipped_bytes += to - from;
  }

  void Cut(std::uint64_t from, std::uint64_t end) {
    if (walk_.cut_bytes == 0) walk_.first_cut = from;
    walk_.cut_bytes += end - from;
  }

  void Take(const UlogStart& start, std::string_view payload);

  ByteFile* file_;
  const std::function<void(char, std::string_view)>& take_;
  std::vector<int> sizes_;  // of the data messages of each id
  UlogWalk walk_;
};

bool UlogWalker::MayBegin(std::string_view bytes) const {
  if (bytes.size() < kULogHeader) return false;
  const UlogStart start = StartOf(bytes);
  if (!IsSize(start.type, start.size)) return false;
  if (start.type != 'D' || bytes.size() < kULogHeader + 2) return true;
  const int size = sizes_[NumberAt<std::uint16_t>(bytes, kULogHeader)];
  return size <= kAnySize || static_cast<std::size_t>(size) == start.size;
}

bool UlogWalker::LooksLikeMessage(std::string_view bytes) const {
  if (bytes.size() < kULogHeader) return false;
  const UlogStart start = StartOf(bytes);
  if (!IsSize(start.type, start.size) || bytes.size() - kULogHeader < start.size) return false;
  const std::string_view payload = bytes.substr(kULogHeader, start.size);
  switch (start.type) {
    case 'F':
      return IsLetter(payload[0]) && IsPrintable(payload) &&
             payload.find(':') != std::string_view::npos;
    case 'A':
      return IsLetter(payload[3]) && IsPrintable(payload.substr(3));
    case 'I':
    case 'P':
      return IsKeyed(payload);
    case 'M':
    case 'Q':
      return IsKeyed(payload.substr(1));
    case 'L':
      return IsText(payload[0], payload.substr(9));
    case 'C':
      return IsText(payload[0], payload.substr(11));
    case 'S':
      return payload == kSyncMagic;
    case 'D': {
      const int size = sizes_[NumberAt<std::uint16_t>(payload, 0)];
      return size == kAnySize || static_cast<std::size_t>(std::max(size, 0)) == start.size;
    }
    case 'O':
    case 'R':
      return true;
    default:
      return false;
  }
}

bool UlogWalker::IsChain(std::string_view bytes, bool is_end) const {
  bool is_sure = false;
  int subscribed = -1;  // by the message before
  for (int i = 0; i < kChain; ++i) {
    if (bytes.empty() && is_end) return i > 1 || is_sure;
    const bool is_first_of_topic = subscribed >= 0 && MayBegin(bytes) &&
                                   StartOf(bytes).type == 'D' &&
                                   bytes.size() >= kULogHeader + StartOf(bytes).size &&
                                   NumberAt<std::uint16_t>(bytes, kULogHeader) == subscribed;
    if (!is_first_of_topic && !LooksLikeMessage(bytes)) return false;
    const UlogStart start = StartOf(bytes);
    if (start.type == 'S') return true;
    is_sure = is_sure ||
              (start.type == 'D' && sizes_[NumberAt<std::uint16_t>(bytes, kULogHeader)] > kAnySize);
    subscribed = start.type == 'A' ? NumberAt<std::uint16_t>(bytes, kULogHeader + 1) : -1;
    bytes.remove_prefix(kULogHeader + start.size);
  }
  return true;
}

std::uint64_t UlogWalker::FindChain(std::uint64_t from, std::uint64_t to, std::uint64_t end) {
  for (std::uint64_t at = from; at < to; at += kULogSearchStep) {
    const std::string_view bytes = View(at, kAhead, end);
    const bool is_end = at + bytes.size() == end;
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(kULogSearchStep, to - at));
    for (std::size_t i = 0; i < count; ++i) {
      if (IsChain(bytes.substr(i), is_end)) return at + i;
    }
  }
  return to;
}

bool UlogWalker::IsZeroTo(std::uint64_t at, std::uint64_t end) {
  while (at < end) {
    const std::string_view bytes = View(at, kULogSearchStep, end);
    if (bytes.find_first_not_of('\0') != std::string_view::npos) return false;
    at += bytes.size();
  }
  return true;
}

void UlogWalker::Take(const UlogStart& start, std::string_view payload) {
  if (start.type == 'A') {
    sizes_[NumberAt<std::uint16_t>(payload, 1)] = kAnySize;
  } else if (start.type == 'D') {
    int& size = sizes_[NumberAt<std::uint16_t>(payload, 0)];
    if (size == kAnySize) size = static_cast<int>(start.size);
  }
  take_(start.type, payload);
}

void UlogWalker::WalkSection(std::uint64_t begin, std::uint64_t end) {
  std::uint64_t at = begin;
  bool is_aligned = true;  // a message ended at `at`, or two follow each other there
  while (at < end) {
    const std::string_view bytes = View(at, 2 * (kULogHeader + kMostPayload), end);
    if (is_aligned && bytes.size() < kULogHeader) {
      Cut(at, end);
      return;
    }
    if (is_aligned && MayBegin(bytes)) {
      const UlogStart start = StartOf(bytes);
      const std::size_t length = kULogHeader + start.size;
      const bool is_whole = length <= bytes.size();
      const std::size_t left = is_whole ? bytes.size() - length : 0;
      const std::string_view behind = bytes.substr(is_whole ? length : bytes.size());
      // Of a type that is not known, any bytes might be; what follows has to look as a message.
      const bool is_followed =
          left < kULogHeader || (MayBegin(behind) && (IsKnown(start.type) || behind[2] == 'D' ||
                                                      LooksLikeMessage(behind)));
      if (is_whole && is_followed) {
        Take(start, bytes.substr(kULogHeader, start.size));
        at += length;
        continue;
      }
      // Damage in its size or behind it.
      const std::uint64_t stop = std::min<std::uint64_t>(at + length, end);
      const std::uint64_t next = FindChain(at + 1, stop, end);
      if (next < stop) {
        Skip(at, next);
        at = next;
      } else if (!is_whole) {
        Cut(at, end);
        return;
      } else {
        Take(start, View(at, length, end).substr(kULogHeader));
        at += length;
        is_aligned = false;
      }
      continue;
    }
    if (IsZeroTo(at, end)) return;  // the last block of a card
    const std::uint64_t next = FindChain(at, end, end);
    Skip(at, next);
    at = next;
    is_aligned = true;
  }
}

}  // namespace

UlogHead ReadUlogHead(ByteFile* file) {
  const std::string path = file->path().string();
  if (file->size() < kFileHeader) {
    throw InputError(fmt::format("{}: ends after {} bytes, expected the {} of a ULog header.",
                                 path,
                                 file->size(),
                                 kFileHeader));
  }
  const std::string bytes(file->View(0, kFileHeader + kULogHeader + kFlags));
  UlogHead head;
  head.version = static_cast<unsigned char>(bytes[7]);
  std::uint64_t begin = kFileHeader;
  const std::string_view message = std::string_view(bytes).substr(kFileHeader);
  if (message.size() == kULogHeader + kFlags && StartOf(message).type == 'B' &&
      StartOf(message).size >= kFlags) {
    constexpr std::size_t kIncompatible = kULogHeader + 8;
    constexpr std::size_t kOffsets = kIncompatible + 8;
    const auto flags = NumberAt<std::uint64_t>(message, kIncompatible);
    if (flags > 1) {
      throw InputError(fmt::format(
          "{}: byte {}: the flags of what an older reader cannot read are {:#x}, expected 0, or 1 "
          "for appended data. The file is of a later kind of ULog.",
          path,
          kFileHeader + kIncompatible,
          flags));
    }
    for (std::size_t i = 0; i < 3 && flags == 1; ++i) {
      const auto offset = NumberAt<std::uint64_t>(message, kOffsets + 8 * i);
      if (offset == 0) break;
      if (offset <= begin || offset > file->size()) {
        head.has_bad_offsets = true;
        break;
      }
      head.sections.emplace_back(begin, offset);
      begin = offset;
    }
  }
  head.sections.emplace_back(begin, file->size());
  return head;
}

UlogWalk ForEachUlogMessage(ByteFile* file,
                            const UlogHead& head,
                            const std::function<void(char type, std::string_view payload)>& take) {
  UlogWalker walker(file, take);
  for (const auto& [begin, end] : head.sections) walker.WalkSection(begin, end);
  return walker.walk();
}

}  // namespace fathom
