// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>

namespace fathom {

// The types of numbers that recordings store.
enum class NumberType {
  kInt8,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kInt64,
  kUint64,
  kFloat32,
  kFloat64,
};

// Bytes of one.
constexpr std::size_t SizeOf(NumberType type) {
  constexpr std::array<std::size_t, 10> kSizes = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

// Of "int8", "uint64", "float32"; nothing for another name.
std::optional<NumberType> NumberTypeNamed(std::string_view name);

// Of 'i' (with a sign), 'u' (without) or 'f' (floating point), and its bytes.
std::optional<NumberType> NumberTypeOf(char kind, std::size_t size);

// The number whose bytes stand at `offset`, the least significant first unless `is_big`. The caller
// has checked that they are there.
template <typename T>
T NumberAt(std::string_view bytes, std::size_t offset, bool is_big = false) {
  static_assert(std::endian::native == std::endian::little);
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), bytes.data() + offset, sizeof(T));
  if (is_big) std::reverse(raw.begin(), raw.end());
  return std::bit_cast<T>(raw);
}

// The same of any type.
double NumberAt(NumberType type, std::string_view bytes, std::size_t offset, bool is_big = false);

}  // namespace fathom
