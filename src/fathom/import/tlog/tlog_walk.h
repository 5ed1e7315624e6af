// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/byte_file.h"

#include <cstdint>
#include <functional>
#include <string_view>

namespace fathom {

// A packet of a tlog, and when it came. It lasts for the call.
struct TlogPacket {
  double time = 0.0;  // [s since 1970]
  int version = 2;    // of MAVLink: 1 or 2
  std::uint32_t id = 0;
  int system = 0;
  int component = 0;
  std::string_view payload;  // of MAVLink 2 without the zeros at its end
};

// What lies between the packets.
struct TlogWalk {
  std::uint64_t skipped_bytes = 0;  // of no packet, or of one whose checksum does not hold
  std::uint64_t first_skipped = 0;  // where they begin
  std::uint64_t cut_bytes = 0;      // of a packet that the file ends in
};

// Whether these bytes begin as a tlog: a time of this age, and a packet.
bool BeginsTlogRecord(std::string_view bytes);

// Calls `take` with every sound packet, in the order of the file. Those of messages that the reader
// knows are sound if their checksum holds; others, whose checksum nobody can tell without their
// definition, if another record follows them.
TlogWalk ForEachTlogPacket(ByteFile* file, const std::function<void(const TlogPacket&)>& take);

}  // namespace fathom
