// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/recording/number_type.h"

#include <string>

namespace fathom {
namespace {

// In the order of NumberType.
constexpr std::string_view kKinds = "iuiuiuiuff";

}  // namespace

std::optional<NumberType> NumberTypeOf(char kind, std::size_t size) {
  for (std::size_t i = 0; i < kKinds.size(); ++i) {
    const auto type = static_cast<NumberType>(i);
    if (kKinds[i] == kind && SizeOf(type) == size) return type;
  }
  return std::nullopt;
}

std::optional<NumberType> NumberTypeNamed(std::string_view name) {
  for (std::size_t i = 0; i < kKinds.size(); ++i) {
    const auto type = static_cast<NumberType>(i);
    const std::string word = kKinds[i] == 'i' ? "int" : kKinds[i] == 'u' ? "uint" : "float";
    if (name == word + std::to_string(8 * SizeOf(type))) return type;
  }
  return std::nullopt;
}

double NumberAt(NumberType type, std::string_view bytes, std::size_t offset, bool is_big) {
  switch (type) {
    case NumberType::kInt8:
      return NumberAt<std::int8_t>(bytes, offset);
    case NumberType::kUint8:
      return NumberAt<std::uint8_t>(bytes, offset);
    case NumberType::kInt16:
      return NumberAt<std::int16_t>(bytes, offset, is_big);
    case NumberType::kUint16:
      return NumberAt<std::uint16_t>(bytes, offset, is_big);
    case NumberType::kInt32:
      return NumberAt<std::int32_t>(bytes, offset, is_big);
    case NumberType::kUint32:
      return NumberAt<std::uint32_t>(bytes, offset, is_big);
    case NumberType::kInt64:
      return static_cast<double>(NumberAt<std::int64_t>(bytes, offset, is_big));
    case NumberType::kUint64:
      return static_cast<double>(NumberAt<std::uint64_t>(bytes, offset, is_big));
    case NumberType::kFloat32:
      return NumberAt<float>(bytes, offset, is_big);
    case NumberType::kFloat64:
      break;
  }
  return NumberAt<double>(bytes, offset, is_big);
}

}  // namespace fathom
