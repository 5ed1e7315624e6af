// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/utc_time.h"

#include "fathom/base/number.h"

#include <chrono>
#include <cmath>

#include <fmt/format.h>

namespace fathom {
namespace {

// The next `digits` digits of `text`, which are taken off.
std::optional<int> TakeNumber(std::string_view* text, std::size_t digits) {
  if (text->size() < digits) return std::nullopt;
  int number = 0;
  for (const char c : text->substr(0, digits)) {
    if (c < '0' || c > '9') return std::nullopt;
    number = 10 * number + (c - '0');
  }
  text->remove_prefix(digits);
  return number;
}

bool TakeOneOf(std::string_view characters, std::string_view* text) {
  if (text->empty() || characters.find(text->front()) == std::string_view::npos) return false;
  text->remove_prefix(1);
  return true;
}

std::optional<double> TakeDay(std::string_view* text) {
  const auto year = TakeNumber(text, 4);
  if (!year || !TakeOneOf("-", text)) return std::nullopt;
  const auto month = TakeNumber(text, 2);
  if (!month || !TakeOneOf("-", text)) return std::nullopt;
  const auto day = TakeNumber(text, 2);
  if (!day) return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year(*year),
                                         std::chrono::month(static_cast<unsigned>(*month)),
                                         std::chrono::day(static_cast<unsigned>(*day))};
  if (!date.ok()) return std::nullopt;
  return 86400.0 * static_cast<double>(std::chrono::sys_days(date).time_since_epoch().count());
}

// hh:mm or hh:mm:ss or hh:mm:ss.fff
std::optional<double> TakeTimeOfDay(std::string_view* text) {
  const auto hour = TakeNumber(text, 2);
  if (!hour || *hour > 23 || !TakeOneOf(":", text)) return std::nullopt;
  const auto minute = TakeNumber(text, 2);
  if (!minute || *minute > 59) return std::nullopt;
  const double whole_minutes = 3600.0 * *hour + 60.0 * *minute;
  if (!TakeOneOf(":", text)) return whole_minutes;
  const auto second = TakeNumber(text, 2);
  if (!second || *second > 60) return std::nullopt;
  double fraction = 0.0;
  if (text->starts_with('.')) {
    const std::size_t end = text->find_first_not_of("0123456789", 1);
    const auto parsed = ParseFiniteNumber(text->substr(0, end));
    if (!parsed) return std::nullopt;
    fraction = *parsed;
    text->remove_prefix(end == std::string_view::npos ? text->size() : end);
  }
  return whole_minutes + *second + fraction;
}

}  // namespace

std::optional<double> ParseUtc(std::string_view text) {
  const auto day = TakeDay(&text);
  if (!day || text.empty()) return day;
  if (!TakeOneOf("T ", &text)) return std::nullopt;
  const auto time_of_day = TakeTimeOfDay(&text);
  if (!time_of_day) return std::nullopt;
  TakeOneOf("Z", &text);
  if (!text.empty()) return std::nullopt;
  return *day + *time_of_day;
}

std::string FormatUtc(double seconds) {
  constexpr double kYear1 = -62135596800.0, kYear10000 = 253402300800.0;
  if (!(seconds >= kYear1 && seconds < kYear10000)) return "";
  const double days = std::floor(seconds / 86400.0);
  const std::chrono::year_month_day date{
      std::chrono::sys_days(std::chrono::days(static_cast<int>(days)))};
  const double whole = std::floor(seconds);
  const int second = static_cast<int>(whole - 86400.0 * days);
  // "0.25" without its zero.
  const std::string fraction =
      whole == seconds ? "" : fmt::format("{:f}", std::floor(1e6 * (seconds - whole)) / 1e6).substr(1);
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}{}Z",
                     static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()),
                     static_cast<unsigned>(date.day()),
                     second / 3600,
                     second / 60 % 60,
                     second % 60,
                     fraction);
}

}  // namespace fathom
