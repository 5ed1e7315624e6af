// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/numpy/numpy_number.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// A header takes so many bytes at most, and an element has so many fields.
inline constexpr std::size_t kMostNpyHeader = std::size_t{1} << 20;
inline constexpr std::size_t kMostNpyFields = 100'000;

// A number within an element of an array.
struct NpyField {
  std::string name;  // "u", "pose.x", "eta.1"; empty: the element is the number
  NumpyNumber number;
  std::size_t offset = 0;  // within the element
};

// What the header of a .npy tells: numpy's NEP 1 and numpy.lib.format, versions 1 to 3.
struct NpyHeader {
  std::vector<NpyField> fields;
  std::uint64_t num_others = 0;  // fields that are no numbers: texts, objects, complex numbers
  std::size_t element_size = 0;  // [bytes]
  bool is_structured = false;
  bool is_fortran = false;           // column by column
  std::vector<std::uint64_t> shape;  // empty: a scalar
  std::size_t size = 0;              // of the header: here the elements begin
};

bool LooksLikeNpy(std::string_view first_bytes);

// Of the first bytes of an array, kMostNpyHeader or all that there are. Throws InputError, which
// names `name`, for a header that is none.
NpyHeader ParseNpyHeader(const std::string& name, std::string_view first_bytes);

}  // namespace fathom
