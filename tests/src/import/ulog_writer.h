// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <string>
#include <string_view>

namespace fathom {

// Writes PX4 logs for tests, from the format's description (docs.px4.io, "ULog File Format").
namespace ulog {

template <typename T>
std::string Bytes(T value) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  return bytes;
}

// A message with its header.
std::string Message(char type, const std::string& payload);

// The file's header and flag bits; `appended`: where data was appended.
std::string Header(std::initializer_list<std::uint64_t> appended = {});

std::string Format(std::string_view text);
std::string Subscribe(int id, std::string_view topic, int instance = 0);
std::string Data(int id, const std::string& data);
std::string Parameter(std::string_view key, float value);
std::string Sync();
std::string Dropout(int milliseconds);

// Format and subscription 0 of vehicle_attitude: timestamp, q[4], count (uint8), padding.
std::string Attitude();
std::string Attitude(std::uint64_t time_us, float qw, int count);

}  // namespace ulog
}  // namespace fathom
