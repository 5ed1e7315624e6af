// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// What a literal of Python stands for, as far as headers of numpy need it.
struct PythonLiteral {
  enum class Kind { kText, kNumber, kTruth, kList, kTuple, kDictionary };
  Kind kind = Kind::kText;
  std::string text;                  // of a text
  std::uint64_t number = 0;          // of a number that is not negative; 1 and 0 of a truth
  std::vector<PythonLiteral> items;  // of a dictionary: key, value, key, value

  // What a dictionary holds under this key; null if nothing.
  const PythonLiteral* Find(std::string_view key) const;
};

// The literal that `text` is, with spaces around it. Nothing if it is none: nested deeper than 20,
// a number of more than 64 bits, anything else of Python.
std::optional<PythonLiteral> ParsePythonLiteral(std::string_view text);

}  // namespace fathom
