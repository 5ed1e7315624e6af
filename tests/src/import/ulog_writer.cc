// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ulog_writer.h"

namespace fathom::ulog {

std::string Message(char type, const std::string& payload) {
  return Bytes(static_cast<std::uint16_t>(payload.size())) + type + payload;
}

std::string Header(std::initializer_list<std::uint64_t> appended) {
  std::string offsets;
  for (const std::uint64_t offset : appended) offsets += Bytes(offset);
  offsets.resize(24, '\0');
  return std::string("ULog\x01\x12\x35\x01", 8) + Bytes<std::uint64_t>(1000000) +
         Message(
             'B',
             Bytes<std::uint64_t>(0) + Bytes<std::uint64_t>(appended.size() > 0 ? 1 : 0) + offsets);
}

std::string Format(std::string_view text) { return Message('F', std::string(text)); }

std::string Subscribe(int id, std::string_view topic, int instance) {
  return Message('A',
                 Bytes(static_cast<std::uint8_t>(instance)) +
                     Bytes(static_cast<std::uint16_t>(id)) + std::string(topic));
}

std::string Data(int id, const std::string& data) {
  return Message('D', Bytes(static_cast<std::uint16_t>(id)) + data);
}

std::string Parameter(std::string_view key, float value) {
  const std::string typed = "float " + std::string(key);
  return Message('P', static_cast<char>(typed.size()) + typed + Bytes(value));
}

std::string Sync() { return Message('S', std::string("\x2f\x73\x13\x20\x25\x0c\xbb\x12", 8)); }

std::string Dropout(int milliseconds) {
  return Message('O', Bytes(static_cast<std::uint16_t>(milliseconds)));
}

std::string Attitude() {
  return Format(
             "vehicle_attitude:uint64_t timestamp;float[4] q;uint8_t count;uint8_t[3] "
             "_padding0;") +
         Subscribe(0, "vehicle_attitude");
}

std::string Attitude(std::uint64_t time_us, float qw, int count) {
  return Data(0,
              Bytes(time_us) + Bytes(qw) + Bytes(0.25F) + Bytes(-0.5F) + Bytes(0.75F) +
                  Bytes(static_cast<std::uint8_t>(count)));
}

}  // namespace fathom::ulog
