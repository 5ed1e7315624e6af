// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <cstring>
#include <string>

namespace fathom {

// Writes telemetry logs for tests, from the description of MAVLink's packets (mavlink.io, "Packet
// Serialization").
namespace tlog {

template <typename T>
std::string Bytes(T value) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  return bytes;
}

// Records with their stamp. MAVLink 2 leaves zeros at the end of the payload out.
std::string Packet2(std::uint64_t time_us,
                    int id,
                    std::string payload,
                    int crc_extra,
                    int system = 1,
                    int component = 1,
                    bool is_signed = false);
std::string Packet1(std::uint64_t time_us, int id, const std::string& payload, int crc_extra);

// ATTITUDE: roll, and a yaw rate.
std::string Attitude(std::uint64_t time_us, float roll, float yawspeed = 0.5F, int system = 1);

}  // namespace tlog
}  // namespace fathom
