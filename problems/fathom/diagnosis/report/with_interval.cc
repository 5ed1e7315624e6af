// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/report/with_interval.h"

#include "fathom/report/format_value.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace fathom {

int DecimalsFor(double size) {
  const int exponent = static_cast<int>(std::floor(std::log10(size)));
  const double first_digit = size / std::pow(10.0, exponent);
  return first_digit < 1.95 ? 1 - exponent : -exponent;
}

std::string RoundedAt(double value, int decimals) {
  constexpr int kMostDecimals = 6;
  if (decimals > kMostDecimals || std::abs(value) >= 1e6) return fmt::format("{:.3g}", value);
  if (decimals < 0) {
    const double unit = std::pow(10.0, -decimals);
    value = std::round(value / unit) * unit;
  }
  std::string text = fmt::format("{:.{}f}", value, std::max(decimals, 0));
  if (text.front() == '-' && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);
  return text;
}

std::string WithInterval(
    double value, double std, std::string_view unit, double lower, double upper) {
  const auto with_unit = [&](const std::string& number) {
    return unit.empty() ? number : fmt::format("{} {}", number, unit);
  };
  if (!std::isfinite(std) || !(std > 0.0)) return with_unit(FormatValue(value));
  const double half = kDeviationsOf95 * std;
  const int decimals = DecimalsFor(half);
  return fmt::format("{} ({} to {})",
                     with_unit(RoundedAt(value, decimals)),
                     RoundedAt(std::max(value - half, lower), decimals),
                     with_unit(RoundedAt(std::min(value + half, upper), decimals)));
}

}  // namespace fathom
