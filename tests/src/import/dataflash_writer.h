// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace fathom {

// Writes ArduPilot DataFlash logs for tests, from the format's description.
namespace dataflash {

template <typename T>
std::string Bytes(T value) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  return bytes;
}

// Text filled up with NUL.
std::string Text(std::string_view text, std::size_t size);

// A message with its header.
std::string Message(int type, const std::string& payload);

// FMT of a type whose messages have so many bytes in all.
std::string Fmt(int type, int length, const char* name, const char* letters, const char* columns);

// The usual FMT of FMTU (131), UNIT (132) and MULT (133).
std::string FmtOfUnits();
std::string Unit(char id, const char* label);
std::string Mult(char id, double multiplier);
std::string Fmtu(int type, const char* unit_ids, const char* multiplier_ids);

inline constexpr int kAtt = 10;

// FMT of ATT: TimeUS (Q), Roll (c), Count (H), Rate (f).
std::string FmtOfAtt();
std::string Att(std::uint64_t time_us, double roll, int count, float rate);

}  // namespace dataflash
}  // namespace fathom
