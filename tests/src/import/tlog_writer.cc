// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tlog_writer.h"

#include <algorithm>

namespace fathom::tlog {
namespace {

std::string Stamp(std::uint64_t time_us) {
  std::string bytes = Bytes(time_us);
  std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

// A byte at a time, as MAVLink's description gives it.
std::string Checksum(const std::string& bytes, int crc_extra) {
  std::uint16_t crc = 0xffff;
  for (const char c : bytes + static_cast<char>(crc_extra)) {
    auto x = static_cast<std::uint8_t>(static_cast<std::uint8_t>(c) ^ (crc & 0xff));
    x = static_cast<std::uint8_t>(x ^ (x << 4));
    crc = static_cast<std::uint16_t>((crc >> 8) ^ (x << 8) ^ (x << 3) ^ (x >> 4));
  }
  return Bytes(crc);
}

}  // namespace

std::string Packet2(std::uint64_t time_us,
                    int id,
                    std::string payload,
                    int crc_extra,
                    int system,
                    int component,
                    bool is_signed) {
  while (payload.size() > 1 && payload.back() == '\0') payload.pop_back();
  std::string packet;
  packet += static_cast<char>(payload.size());
  packet += is_signed ? '\1' : '\0';
  packet += std::string(2, '\0');  // compatible flags, sequence
  packet += static_cast<char>(system);
  packet += static_cast<char>(component);
  packet += Bytes(id).substr(0, 3) + payload;
  return Stamp(time_us) + '\xfd' + packet + Checksum(packet, crc_extra) +
         (is_signed ? std::string(13, 's') : "");
}

std::string Packet1(std::uint64_t time_us, int id, const std::string& payload, int crc_extra) {
  std::string packet;
  packet += static_cast<char>(payload.size());
  packet += std::string("\0\1\1", 3);  // sequence, system, component
  packet += static_cast<char>(id) + payload;
  return Stamp(time_us) + '\xfe' + packet + Checksum(packet, crc_extra);
}

std::string Attitude(std::uint64_t time_us, float roll, float yawspeed, int system) {
  return Packet2(time_us,
                 30,
                 Bytes<std::uint32_t>(7) + Bytes(roll) + Bytes(0.25F) + Bytes(-1.5F) + Bytes(0.0F) +
                     Bytes(0.0F) + Bytes(yawspeed),
                 39,
                 system);
}

}  // namespace fathom::tlog
