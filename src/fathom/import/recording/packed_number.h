// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/number_type.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// Of the words of which autopilots make messages, "uint8_t", "float", "bool", "char": ULog
// (docs.px4.io, "ULog File Format", Data types) and MAVLink (mavlink.io, "Packet Serialization").
// Nothing for another one.
std::optional<NumberType> PackedTypeNamed(std::string_view name);

// A number of a message, nested types and arrays taken apart: "timestamp", "q[3]", "esc[0].rpm".
struct PackedNumber {
  std::string name;
  NumberType type = NumberType::kUint8;
  std::size_t offset = 0;  // from the first byte of the message's data
  bool is_text = false;    // a character of one
};

// The number of this name; null if there is none.
const PackedNumber* FindNumber(const std::vector<PackedNumber>& numbers, std::string_view name);

// The number as it stands, its least significant byte first; NaN where the data ends before it.
double ValueOf(const PackedNumber& number, std::string_view data);

}  // namespace fathom
