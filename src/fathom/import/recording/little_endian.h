// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <bit>
#include <cstddef>
#include <cstring>
#include <string_view>

namespace fathom {

// The number whose bytes stand at `offset`, the least significant first. The caller has checked
// that they are there.
template <typename T>
T LittleEndian(std::string_view bytes, std::size_t offset) {
  static_assert(std::endian::native == std::endian::little);
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof(T));
  return value;
}

}  // namespace fathom
