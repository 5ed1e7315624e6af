// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/recording/packed_number.h"

#include "fathom/import/recording/little_endian.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace fathom {
namespace {

constexpr std::array<std::pair<std::string_view, PackedType>, 12> kTypes = {
    {{"int8_t", PackedType::kInt8},
     {"uint8_t", PackedType::kUint8},
     {"int16_t", PackedType::kInt16},
     {"uint16_t", PackedType::kUint16},
     {"int32_t", PackedType::kInt32},
     {"uint32_t", PackedType::kUint32},
     {"int64_t", PackedType::kInt64},
     {"uint64_t", PackedType::kUint64},
     {"float", PackedType::kFloat},
     {"double", PackedType::kDouble},
     {"bool", PackedType::kBool},
     {"char", PackedType::kChar}}};

template <typename T>
double NumberAt(std::string_view data, std::size_t offset) {
  return static_cast<double>(LittleEndian<T>(data, offset));
}

}  // namespace

std::optional<PackedType> PackedTypeNamed(std::string_view name) {
  for (const auto& [known, type] : kTypes) {
    if (known == name) return type;
  }
  return std::nullopt;
}

std::size_t SizeOf(PackedType type) {
  switch (type) {
    case PackedType::kInt8:
    case PackedType::kUint8:
    case PackedType::kBool:
    case PackedType::kChar:
      return 1;
    case PackedType::kInt16:
    case PackedType::kUint16:
      return 2;
    case PackedType::kInt32:
    case PackedType::kUint32:
    case PackedType::kFloat:
      return 4;
    case PackedType::kInt64:
    case PackedType::kUint64:
    case PackedType::kDouble:
      return 8;
  }
  return 1;
}

double ValueOf(const PackedNumber& number, std::string_view data) {
  const std::size_t at = number.offset;
  if (data.size() < at || data.size() - at < SizeOf(number.type)) return NAN;
  switch (number.type) {
    case PackedType::kInt8:
    case PackedType::kChar:
      return NumberAt<std::int8_t>(data, at);
    case PackedType::kUint8:
    case PackedType::kBool:
      return NumberAt<std::uint8_t>(data, at);
    case PackedType::kInt16:
      return NumberAt<std::int16_t>(data, at);
    case PackedType::kUint16:
      return NumberAt<std::uint16_t>(data, at);
    case PackedType::kInt32:
      return NumberAt<std::int32_t>(data, at);
    case PackedType::kUint32:
      return NumberAt<std::uint32_t>(data, at);
    case PackedType::kInt64:
      return NumberAt<std::int64_t>(data, at);
    case PackedType::kUint64:
      return NumberAt<std::uint64_t>(data, at);
    case PackedType::kFloat:
      return NumberAt<float>(data, at);
    case PackedType::kDouble:
      return NumberAt<double>(data, at);
  }
  return NAN;
}

}  // namespace fathom
