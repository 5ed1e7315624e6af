// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/files/yaml_numbers.h"

#include <fmt/format.h>

namespace fathom {

double Within(const YamlMap& map, std::string_view key, double number, double from, double to) {
  if (from <= number && number <= to) return number;
  map.Fail(key, fmt::format("is {}, expected a number from {} to {}.", number, from, to));
}

double NumberWithin(const YamlMap& map, std::string_view key, double from, double to) {
  return Within(map, key, map.Number(key), from, to);
}

double NumberWithin(
    const YamlMap& map, std::string_view key, double from, double to, double if_missing) {
  return Within(map, key, map.Number(key, if_missing), from, to);
}

double Positive(const YamlMap& map, std::string_view key) {
  const double number = map.Number(key);
  if (number > 0.0 && number <= kLargest) return number;
  map.Fail(key, fmt::format("is {}, expected a number above 0 and at most {}.", number, kLargest));
}

double Amplitude(const YamlMap& map, std::string_view key) {
  return NumberWithin(map, key, -kLargest, kLargest);
}

}  // namespace fathom
