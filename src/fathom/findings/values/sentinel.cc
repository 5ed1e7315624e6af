// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/values/sentinel.h"

#include "fathom/base/quantile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace fathom {
namespace {

constexpr double kFarOfKnown = 2.0;  // times the furthest of the others
constexpr double kFar = 5.0;
constexpr double kMostRows = 0.5;  // of all

// Whether the digits, wherever the point, are those of a known "no reading".
bool IsKnown(double value) {
  const double size = std::abs(value);
  if (size >= 1e6) return true;
  const auto has_digits = [&](double digits) {
    for (double scaled = digits; scaled > 1e-3; scaled /= 10.0) {
      if (std::abs(size - scaled) < 1e-9 * scaled) return true;
    }
    return false;
  };
  constexpr std::array<double, 8> kDigits = {
      32767.0, 32768.0, 65535.0, 65536.0, 99.0, 999.0, 9999.0, 99999.0};
  return size > 9.0 && std::ranges::any_of(kDigits, has_digits);
}

}  // namespace

std::optional<Sentinel> FindSentinel(std::span<const double> values) {
  if (values.size() < 3) return std::nullopt;
  const double middle = Quantile({values.begin(), values.end()}, 0.5);
  const auto furthest =
      std::ranges::max_element(values, {}, [&](double value) { return std::abs(value - middle); });
  Sentinel sentinel = {.value = *furthest, .num_rows = 0, .first = 0};
  double far_of_others = 0.0;
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (values[row] != sentinel.value) {
      far_of_others = std::max(far_of_others, std::abs(values[row] - middle));
      continue;
    }
    if (sentinel.num_rows == 0) sentinel.first = row;
    ++sentinel.num_rows;
  }
  const double distance = std::abs(sentinel.value - middle);
  const bool is_sentinel =
      far_of_others > 0.0 &&
      static_cast<double>(sentinel.num_rows) < kMostRows * static_cast<double>(values.size()) &&
      (IsKnown(sentinel.value) ? distance > kFarOfKnown * far_of_others
                               : sentinel.num_rows > 1 && distance > kFar * far_of_others);
  if (!is_sentinel) return std::nullopt;
  return sentinel;
}

}  // namespace fathom
