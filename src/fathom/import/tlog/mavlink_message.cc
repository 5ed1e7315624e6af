// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/tlog/mavlink_message.h"

#include "fathom/base/number.h"
#include "fathom/import/recording/data_files.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

// The text up to a separator, which is taken off with it.
std::string_view TakeWord(std::string_view* text, char separator) {
  const std::string_view word = text->substr(0, text->find(separator));
  text->remove_prefix(std::min(word.size() + 1, text->size()));
  return word;
}

// What one line adds to a message.
void AddMavlinkField(std::string_view line, MavlinkMessage* message) {
  const std::string_view type = TakeWord(&line, ' ');
  const std::string_view name = TakeWord(&line, ' ');
  const std::size_t bracket = type.find('[');
  const bool is_array = bracket != std::string_view::npos;
  int count = 1;
  if (is_array) std::from_chars(type.data() + bracket + 1, type.data() + type.size() - 1, count);
  const std::string_view word = type.substr(0, bracket);
  const NumberType packed = PackedTypeNamed(word).value_or(NumberType::kUint8);
  for (int i = 0; i < count; ++i) {
    std::string element = is_array ? fmt::format("{}[{}]", name, i) : std::string(name);
    message->numbers.push_back({std::move(element), packed, message->size, word == "char"});
    message->units.emplace_back(line);
    message->size += SizeOf(packed);
  }
}

// Of data/import/mavlink_messages.txt.
std::map<std::uint32_t, MavlinkMessage> KnownMavlinkMessages() {
  std::map<std::uint32_t, MavlinkMessage> messages;
  MavlinkMessage* message = nullptr;
  for (std::string_view text = data_files::mavlink_messages; !text.empty();) {
    std::string_view line = TakeWord(&text, '\n');
    if (line.starts_with('#')) continue;
    if (line.starts_with("  ")) {
      AddMavlinkField(line.substr(2), message);
      continue;
    }
    const auto number = ParseFiniteNumber(TakeWord(&line, ' '));
    message = &messages[static_cast<std::uint32_t>(number.value())];
    message->id = static_cast<std::uint32_t>(number.value());
    message->name = TakeWord(&line, ' ');
    message->crc_extra = static_cast<std::uint8_t>(ParseFiniteNumber(line).value());
  }
  return messages;
}

// What eight steps of the checksum, a bit each, make of every byte.
constexpr std::array<std::uint16_t, 256> ChecksumsOfBytes() {
  std::array<std::uint16_t, 256> checksums = {};
  for (std::size_t byte = 0; byte < checksums.size(); ++byte) {
    auto crc = static_cast<std::uint16_t>(byte);
    for (int bit = 0; bit < 8; ++bit) {
      crc = static_cast<std::uint16_t>((crc & 1) != 0 ? (crc >> 1) ^ 0x8408 : crc >> 1);
    }
    checksums[byte] = crc;
  }
  return checksums;
}

}  // namespace

const MavlinkMessage* FindMavlinkMessage(std::uint32_t id) {
  static const auto* const kMessages =
      new std::map<std::uint32_t, MavlinkMessage>(KnownMavlinkMessages());
  const auto found = kMessages->find(id);
  return found == kMessages->end() ? nullptr : &found->second;
}

std::uint16_t MavlinkChecksum(std::string_view bytes, std::uint8_t crc_extra) {
  static constexpr std::array<std::uint16_t, 256> kOfByte = ChecksumsOfBytes();
  std::uint16_t crc = 0xffff;
  const auto take = [&crc](unsigned char byte) {
    crc = static_cast<std::uint16_t>((crc >> 8) ^ kOfByte[(crc ^ byte) & 0xff]);
  };
  for (const char c : bytes) take(static_cast<unsigned char>(c));
  take(crc_extra);
  return crc;
}

}  // namespace fathom
