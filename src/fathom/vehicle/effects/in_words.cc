// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/effects/in_words.h"

#include "fathom/vehicle/effects/catalogue.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <cctype>
#include <cstddef>

namespace fathom {
namespace {

bool IsOfName(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// Behind or before such a letter a name is a part of a path or a flag.
bool IsOfPath(char c) { return c == '/' || c == '-' || c == '=' || c == '\\'; }

bool IsKnown(std::string_view name) {
  const bool is_parameter = std::ranges::any_of(
      kParameterInfo, [&](const ParameterInfo& info) { return info.name == name; });
  return is_parameter || FindEffect(name) != nullptr;
}

}  // namespace

std::string InWords(std::string_view sentence) {
  std::string text;
  for (std::size_t i = 0; i < sentence.size();) {
    std::size_t end = i;
    while (end < sentence.size() && IsOfName(sentence[end])) ++end;
    if (end == i) {
      text += sentence[i] == '`' ? '"' : sentence[i];
      ++i;
      continue;
    }
    std::string name(sentence.substr(i, end - i));
    const bool is_of_path =
        (i > 0 && IsOfPath(sentence[i - 1])) ||
        (end < sentence.size() && IsOfPath(sentence[end])) ||
        (end + 1 < sentence.size() && sentence[end] == '.' && IsOfName(sentence[end + 1]));
    if (!is_of_path && IsKnown(name)) std::ranges::replace(name, '_', ' ');
    text += name;
    i = end;
  }
  return text;
}

}  // namespace fathom
