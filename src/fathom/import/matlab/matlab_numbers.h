// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/number_type.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace fathom {

// Takes numbers out of the bytes of a .mat.
struct MatlabByteOrder {
  bool is_big = false;

  std::uint32_t Uint32At(std::string_view bytes, std::size_t offset) const {
    return NumberAt<std::uint32_t>(bytes, offset, is_big);
  }
};

// The numbers of an array, column by column as MATLAB keeps them.
struct MatlabNumbers {
  std::shared_ptr<const std::string> bytes;
  std::size_t offset = 0;  // of the first number
  NumberType type = NumberType::kFloat64;
  MatlabByteOrder order;

  double At(std::size_t index) const {
    return NumberAt(type, *bytes, offset + index * SizeOf(type), order.is_big);
  }
};

}  // namespace fathom
