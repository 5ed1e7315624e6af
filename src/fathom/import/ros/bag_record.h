// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/byte_file.h"
#include "fathom/import/recording/number_type.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace fathom {

// The fields of the header of a record of a bag: "name=value" each behind its length.
class BagFields {
 public:
  // Nothing where they do not fit together.
  static std::optional<BagFields> Parse(std::string_view bytes);

  // Empty if it is not there. They are few: looked through again for each name.
  std::string_view Text(std::string_view name) const;

  // Nothing if it is not there, or has another size.
  template <typename T>
  std::optional<T> Number(std::string_view name) const {
    const std::string_view text = Text(name);
    if (text.size() != sizeof(T)) return std::nullopt;
    return NumberAt<T>(text, 0);
  }

 private:
  std::string_view bytes_;
};

// What a record of a bag is: its field "op".
inline constexpr char kBagMessage = 0x02;
inline constexpr char kBagHeader = 0x03;
inline constexpr char kBagIndex = 0x04;  // of one connection's messages in the chunk before it
inline constexpr char kBagChunk = 0x05;
inline constexpr char kBagConnection = 0x07;

// A record of a bag: the length of its header, its header, the length of its data, its data.
struct BagRecord {
  BagFields header;
  char op = 0;
  std::string_view data;
  std::uint64_t data_offset = 0;  // in what the record was read from
  std::uint64_t data_size = 0;    // as stated: more than `data` holds if that is cut

  bool IsWhole() const { return data.size() == data_size; }
};

// The record at the start of `bytes`, whose data may be cut off; nothing where none begins.
std::optional<BagRecord> BagRecordAt(std::string_view bytes);

// A larger one is damage.
inline constexpr std::uint64_t kLargestBagRecord = std::uint64_t{1} << 28;  // [bytes]

// The record at a place in the file, with all of its data if it is a message or a connection. It
// lasts until the file is read again.
std::optional<BagRecord> BagRecordIn(ByteFile* file, std::uint64_t at);

}  // namespace fathom
