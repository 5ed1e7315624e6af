// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/format_value.h"

#include "fathom/base/interval95.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include <fmt/format.h>

namespace fathom {
namespace {

// Beyond these a number is written with a power of ten.
constexpr double kSmallest = 1e-3;
constexpr double kLargest = 1e6;

// The interval may end at most this many digits behind the first digit of the value.
constexpr int kMostDigits = 9;

// Exponent of the first digit that is left when `number` is rounded to `num_digits`.
int FirstDigit(double number, int num_digits) {
  const std::string text = fmt::format("{:.{}e}", std::abs(number), num_digits - 1);
  return std::stoi(text.substr(text.find('e') + 1));
}

// Rounded at the digit 10^-decimals, which may stand before the point.
std::string Rounded(double number, int decimals) {
  if (decimals < 0) {
    const double unit = std::pow(10.0, -decimals);
    number = std::round(number / unit) * unit;
  }
  std::string text = fmt::format("{:.{}f}", number, std::max(decimals, 0));
  if (text.front() == '-' && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);
  return text;
}

std::string FormatAlone(double value) {
  if (std::isinf(value)) return value > 0.0 ? "inf" : "-inf";
  if (value == 0.0) return "0";
  const double size = std::abs(value);
  if (size < kSmallest || size >= kLargest) return fmt::format("{:.3e}", value);
  return Rounded(value, std::max(3 - FirstDigit(value, 4), 0));
}

// Where a number and its deviation are rounded, by exponents of their digits.
struct Digits {
  int first = 0;
  int last = 0;
  bool has_power = false;  // whether a power of ten is taken out

  bool AreTooMany() const { return first - last > kMostDigits; }

  // Both numbers end at the last digit.
  std::string Write(double a, std::string_view between, double b) const {
    if (!has_power) return fmt::format("{}{}{}", Rounded(a, -last), between, Rounded(b, -last));
    const double scale = std::pow(10.0, first);
    return fmt::format("({}{}{})e{:+03d}",
                       Rounded(a / scale, first - last),
                       between,
                       Rounded(b / scale, first - last),
                       first);
  }
};

Digits DigitsOf(double value, double std) {
  const double size = std::max(std::abs(value), std);
  return {.first = FirstDigit(size, 4),
          .last = FirstDigit(std, 2) - 1,
          .has_power = size < kSmallest || size >= kLargest};
}

}  // namespace

std::string FormatValue(double value, double std) {
  if (std::isnan(value)) return "-";
  if (std::isnan(std)) return FormatAlone(value);
  if (std::isinf(value) || std::isinf(std)) return FormatAlone(value) + " ± " + FormatAlone(std);
  if (std == 0.0) return FormatAlone(value) + " ± 0";

  const Digits digits = DigitsOf(value, std);
  if (digits.AreTooMany()) return fmt::format("{:.{}g} ± {:.0e}", value, kMostDigits, std);
  return digits.Write(value, " ± ", std);
}

std::string FormatInterval(double value, double std, double lower_bound) {
  if (!std::isfinite(value) || !std::isfinite(std)) return "-";
  double from = value - kStdsOf95 * std;
  if (value >= lower_bound) from = std::max(from, lower_bound);
  const double to = value + kStdsOf95 * std;
  if (std == 0.0) return FormatAlone(value) + " ... " + FormatAlone(value);
  const Digits digits = DigitsOf(value, std);
  if (digits.AreTooMany()) return fmt::format("{0:.{2}g} ... {1:.{2}g}", from, to, kMostDigits);
  return digits.Write(from, " ... ", to);
}

std::string UnitText(std::string_view unit) {
  std::string text;
  while (!unit.empty()) {
    const bool is_square = unit.starts_with("^2"), is_cube = unit.starts_with("^3");
    text += is_square ? "²" : is_cube ? "³" : std::string(unit.substr(0, 1));
    unit.remove_prefix(is_square || is_cube ? 2 : 1);
  }
  return text;
}

std::string WithInterval(
    double value, double std, std::string_view unit, double lower, double upper) {
  const auto with_unit = [&](const std::string& number) {
    return unit.empty() ? number : fmt::format("{} {}", number, UnitText(unit));
  };
  if (!std::isfinite(std) || !(std > 0.0)) return with_unit(FormatValue(value));
  const double half = kStdsOf95 * std;
  const int decimals = DecimalsFor(half);
  return fmt::format("{} ({} to {})",
                     with_unit(RoundedAt(value, decimals)),
                     RoundedAt(std::max(value - half, lower), decimals),
                     with_unit(RoundedAt(std::min(value + half, upper), decimals)));
}

int DecimalsFor(double size) {
  const int exponent = static_cast<int>(std::floor(std::log10(size)));
  const double first_digit = size / std::pow(10.0, exponent);
  return first_digit < 1.95 ? 1 - exponent : -exponent;
}

std::string RoundedAt(double value, int decimals) {
  constexpr int kMostDecimals = 6;
  constexpr int kFewestDigits = 3;
  const bool needs_power = decimals > kMostDecimals || std::abs(value) >= kLargest;
  if (!needs_power) return Rounded(value, decimals);
  const int digits = value == 0.0 ? 1 : FirstDigit(value, kMostDigits) + decimals + 1;
  return fmt::format("{:.{}g}", value, std::clamp(digits, kFewestDigits, kMostDigits));
}

std::string ShareText(double share, int decimals) {
  if (!std::isfinite(share)) return "-";
  const bool is_shown = share == 0.0 || std::abs(share) >= 10.0 * std::pow(0.1, decimals);
  return is_shown ? fmt::format("{:.{}f}", share, decimals) : fmt::format("{:.2g}", share);
}

}  // namespace fathom
