// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/matlab/matlab_numbers.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace fathom {
namespace {

static_assert(std::endian::native == std::endian::little);

template <typename T>
T Read(std::string_view bytes, std::size_t offset, bool is_big) {
  std::array<char, sizeof(T)> own;
  std::memcpy(own.data(), bytes.data() + offset, sizeof(T));
  if (is_big) std::reverse(own.begin(), own.end());
  return std::bit_cast<T>(own);
}

}  // namespace

std::size_t SizeOf(MatlabNumberType type) {
  switch (type) {
    case MatlabNumberType::kInt8:
    case MatlabNumberType::kUint8:
      return 1;
    case MatlabNumberType::kInt16:
    case MatlabNumberType::kUint16:
      return 2;
    case MatlabNumberType::kInt32:
    case MatlabNumberType::kUint32:
    case MatlabNumberType::kSingle:
      return 4;
    case MatlabNumberType::kInt64:
    case MatlabNumberType::kUint64:
    case MatlabNumberType::kDouble:
      break;
  }
  return 8;
}

double MatlabByteOrder::NumberAt(std::string_view bytes,
                                 std::size_t offset,
                                 MatlabNumberType type) const {
  switch (type) {
    case MatlabNumberType::kInt8:
      return Read<std::int8_t>(bytes, offset, is_big);
    case MatlabNumberType::kUint8:
      return Read<std::uint8_t>(bytes, offset, is_big);
    case MatlabNumberType::kInt16:
      return Read<std::int16_t>(bytes, offset, is_big);
    case MatlabNumberType::kUint16:
      return Read<std::uint16_t>(bytes, offset, is_big);
    case MatlabNumberType::kInt32:
      return Read<std::int32_t>(bytes, offset, is_big);
    case MatlabNumberType::kUint32:
      return Read<std::uint32_t>(bytes, offset, is_big);
    case MatlabNumberType::kInt64:
      return static_cast<double>(Read<std::int64_t>(bytes, offset, is_big));
    case MatlabNumberType::kUint64:
      return static_cast<double>(Read<std::uint64_t>(bytes, offset, is_big));
    case MatlabNumberType::kSingle:
      return Read<float>(bytes, offset, is_big);
    case MatlabNumberType::kDouble:
      break;
  }
  return Read<double>(bytes, offset, is_big);
}

std::uint32_t MatlabByteOrder::Uint32At(std::string_view bytes, std::size_t offset) const {
  return Read<std::uint32_t>(bytes, offset, is_big);
}

}  // namespace fathom
