// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/packed_number.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// A MAVLink message that the reader takes apart; mavlink.io, "Packet Serialization".
struct MavlinkMessage {
  std::uint32_t id = 0;
  std::string name;
  std::uint8_t crc_extra = 0;         // what the checksum takes in besides the packet
  std::size_t size = 0;               // of the payload with all its fields [bytes]
  std::vector<PackedNumber> numbers;  // in the order of the payload
  std::vector<std::string> units;     // of the numbers, as the definition states them; may be empty

  const PackedNumber* Find(std::string_view field) const { return FindNumber(numbers, field); }
};

// Null if the reader does not know the message of this number.
const MavlinkMessage* FindMavlinkMessage(std::uint32_t id);

// The checksum of MAVLink: CRC-16/MCRF4XX, which it calls X.25, of these bytes and one more.
std::uint16_t MavlinkChecksum(std::string_view bytes, std::uint8_t crc_extra);

}  // namespace fathom
