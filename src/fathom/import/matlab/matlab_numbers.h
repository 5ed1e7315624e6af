// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace fathom {

// How a number of a .mat is stored.
enum class MatlabNumberType {
  kInt8,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kInt64,
  kUint64,
  kSingle,
  kDouble
};

// [bytes]
std::size_t SizeOf(MatlabNumberType type);

// Takes numbers out of the bytes of a .mat.
struct MatlabByteOrder {
  bool is_big = false;

  // The number of this type whose bytes stand at `offset`. The caller has checked that they are
  // there.
  double NumberAt(std::string_view bytes, std::size_t offset, MatlabNumberType type) const;

  std::uint32_t Uint32At(std::string_view bytes, std::size_t offset) const;
};

// The numbers of an array, column by column as MATLAB keeps them.
struct MatlabNumbers {
  std::shared_ptr<const std::string> bytes;
  std::size_t offset = 0;  // of the first number
  MatlabNumberType type = MatlabNumberType::kDouble;
  MatlabByteOrder order;

  double At(std::size_t index) const {
    return order.NumberAt(*bytes, offset + index * SizeOf(type), type);
  }
};

}  // namespace fathom
