// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/number_type.h"

#include <cstddef>
#include <optional>
#include <string_view>

namespace fathom {

// How an element of an array of numpy is stored: numpy's "array interface", typestr.
struct NumpyNumber {
  char kind = 'f';  // f, i, u, b as in numpy; M: a count since 1970; m: a duration; e: a half
  NumberType type = NumberType::kFloat64;
  bool is_big = false;
  double per_second = 1.0;  // ticks of a date or a duration
};

// An element of any type.
struct NumpyType {
  std::size_t size = 0;               // [bytes]
  std::optional<NumpyNumber> number;  // nothing for a text, an object, a complex number
};

// Of "<f8", "|b1", ">M8[ns]". Nothing for what is no type of numpy, or has 2 GB and more.
std::optional<NumpyType> ParseNumpyType(std::string_view text);

// The number whose bytes stand at `offset`: NaN where they are not there, and for no date. A date
// or a duration is in seconds.
double ValueOf(const NumpyNumber& number, std::string_view bytes, std::size_t offset);

}  // namespace fathom
