// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/input_error.h"

#include <string>
#include <vector>

namespace fathom {

// Splits at commas; empty for an empty text.
std::vector<std::string> SplitAtCommas(const std::string& text);

// What stands between the values of a repeated flag: ASCII's unit separator, which no path holds.
inline constexpr char kBetweenValues = '\x1f';

// The values of a flag that may be given several times, in their order; none of an empty text.
std::vector<std::string> RepeatedValues(const std::string& flag);

// The paths of a flag that may be given several times, with one value or several comma-separated
// ones. A path that is there may hold a comma.
std::vector<std::string> PathsInValues(const std::string& flag);

// Throws InputError if the value of a flag that takes one path names several: "--log: names 2,
// expected one ..."
void RequireOnePath(const std::string& flag, const std::string& value);

// parse(text), with the flag's name before what it says of a text it cannot use.
template <typename Parse>
auto ParseFlag(const std::string& flag, const std::string& text, Parse parse) {
  try {
    return parse(text);
  } catch (const InputError& error) {
    throw InputError("--" + flag + ": " + error.what());
  }
}

}  // namespace fathom
