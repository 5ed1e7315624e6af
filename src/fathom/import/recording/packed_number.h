// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace fathom {

// The types of numbers of which autopilots make messages, named as in C: ULog (docs.px4.io, "ULog
// File Format", Data types) and MAVLink (mavlink.io, "Packet Serialization").
enum class PackedType {
  kInt8,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kInt64,
  kUint64,
  kFloat,
  kDouble,
  kBool,
  kChar,
};

// Of "uint8_t", "float"; nothing for another name.
std::optional<PackedType> PackedTypeNamed(std::string_view name);

// Bytes of one.
std::size_t SizeOf(PackedType type);

// A number of a message, nested types and arrays taken apart: "timestamp", "q[3]", "esc[0].rpm".
struct PackedNumber {
  std::string name;
  PackedType type = PackedType::kUint8;
  std::size_t offset = 0;  // from the first byte of the message's data
};

// The number as it stands, its least significant byte first; NaN where the data ends before it.
double ValueOf(const PackedNumber& number, std::string_view data);

}  // namespace fathom
