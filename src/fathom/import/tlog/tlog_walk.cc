// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/tlog/tlog_walk.h"

#include "fathom/import/recording/number_type.h"
#include "fathom/import/tlog/mavlink_message.h"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace fathom {
namespace {

constexpr std::size_t kStamp = 8;  // microseconds since 1970, the most significant byte first
constexpr std::size_t kLongest = 8 + 280;  // a record: stamp, MAVLink 2 with a signature
constexpr std::size_t kChecksum = 2;
constexpr std::size_t kSignature = 13;
constexpr std::size_t kTlogSearchStep = std::size_t{1} << 16;  // of a search [bytes]
constexpr std::uint64_t kYear1990 = 631152000000000;           // [us]
constexpr std::uint64_t kYear2100 = 4102444800000000;          // [us]

std::uint64_t StampOf(std::string_view bytes) {
  std::uint64_t stamp = 0;
  for (std::size_t i = 0; i < kStamp; ++i) {
    stamp = stamp << 8 | static_cast<unsigned char>(bytes[i]);
  }
  return stamp;
}

// A record as its header says.
struct TlogRecord {
  TlogPacket packet;
  std::size_t header = 0;  // of the packet [bytes]
  std::size_t size = 0;    // of the whole record
};

// Nothing if none begins here, or the bytes do not hold its header.
std::optional<TlogRecord> RecordAt(std::string_view bytes) {
  if (!BeginsTlogRecord(bytes)) return std::nullopt;
  const std::string_view packet = bytes.substr(kStamp);
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(packet[i]); };
  TlogRecord record;
  record.packet.time = static_cast<double>(StampOf(bytes)) * 1e-6;
  record.packet.version = byte(0) == 0xfe ? 1 : 2;
  record.header = record.packet.version == 1 ? 6 : 10;
  if (packet.size() < record.header) return std::nullopt;
  const std::size_t id_at = record.packet.version == 1 ? 5 : 7;
  record.packet.system = byte(id_at - 2);
  record.packet.component = byte(id_at - 1);
  record.packet.id = byte(id_at);
  const bool is_signed = record.packet.version == 2 && (byte(2) & 1) != 0;
  if (record.packet.version == 2) {
    record.packet.id |=
        static_cast<std::uint32_t>(byte(8)) << 8 | static_cast<std::uint32_t>(byte(9)) << 16;
  }
  const std::size_t length = byte(1);
  record.size = kStamp + record.header + length + kChecksum + (is_signed ? kSignature : 0);
  if (bytes.size() >= record.size) record.packet.payload = packet.substr(record.header, length);
  return record;
}

// The record that these bytes begin with, if it is sound. `is_end`: the file ends where they do.
std::optional<TlogRecord> SoundRecordAt(std::string_view bytes, bool is_end) {
  const auto record = RecordAt(bytes);
  if (!record || bytes.size() < record->size) return std::nullopt;
  const MavlinkMessage* message = FindMavlinkMessage(record->packet.id);
  if (message == nullptr) {
    const std::string_view behind = bytes.substr(record->size);
    const bool is_cut = is_end && behind.size() <= kStamp;
    return is_cut || BeginsTlogRecord(behind) ? record : std::nullopt;
  }
  // All but the byte that begins the packet.
  const std::size_t end = kStamp + record->header + record->packet.payload.size();
  const std::uint16_t checksum =
      MavlinkChecksum(bytes.substr(kStamp + 1, end - kStamp - 1), message->crc_extra);
  return checksum == NumberAt<std::uint16_t>(bytes, end) ? record : std::nullopt;
}

// The first place from `from` on where a sound record begins; the end of the file if there is none.
std::uint64_t FindSoundRecord(ByteFile* file, std::uint64_t from) {
  for (std::uint64_t at = from; at < file->size(); at += kTlogSearchStep) {
    const std::string_view bytes = file->View(at, kTlogSearchStep + 2 * kLongest);
    const bool is_end = at + bytes.size() == file->size();
    for (std::size_t i = 0; i < std::min(kTlogSearchStep, bytes.size()); ++i) {
      if (SoundRecordAt(bytes.substr(i), is_end)) return at + i;
    }
  }
  return file->size();
}

}  // namespace

bool BeginsTlogRecord(std::string_view bytes) {
  if (bytes.size() <= kStamp || (bytes[kStamp] != '\xfe' && bytes[kStamp] != '\xfd')) return false;
  const std::uint64_t stamp = StampOf(bytes);
  return stamp > kYear1990 && stamp < kYear2100;
}

TlogWalk ForEachTlogPacket(ByteFile* file, const std::function<void(const TlogPacket&)>& take) {
  TlogWalk walk;
  std::uint64_t at = 0;
  while (at < file->size()) {
    const std::string_view bytes = file->View(at, 2 * kLongest);
    const bool is_end = at + bytes.size() == file->size();
    if (const auto record = SoundRecordAt(bytes, is_end)) {
      take(record->packet);
      at += record->size;
      continue;
    }
    const auto cut = RecordAt(bytes);
    const bool is_cut = is_end && (cut ? cut->size > bytes.size()
                                       : bytes.size() <= kStamp || BeginsTlogRecord(bytes));
    const std::uint64_t next = FindSoundRecord(file, at + 1);
    if (is_cut && next == file->size()) {
      walk.cut_bytes = file->size() - at;
      return walk;
    }
    if (walk.skipped_bytes == 0) walk.first_skipped = at;
    walk.skipped_bytes += next - at;
    at = next;
  }
  return walk;
}

}  // namespace fathom
