// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/csv/unit_suffix.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <span>

namespace fathom {
namespace {

constexpr std::string_view kTimeUnits[] = {"s",
                                           "sec",
                                           "secs",
                                           "seconds",
                                           "ms",
                                           "msec",
                                           "millis",
                                           "us",
                                           "usec",
                                           "micros",
                                           "ns",
                                           "nsec",
                                           "nanos",
                                           "min",
                                           "h",
                                           "epoch",
                                           "unix"};
constexpr std::string_view kMotionUnits[] = {
    "m",   "mm",   "cm",    "km",  "ft",      "ms",  "mps",  "mms",   "mmps",
    "cms", "cmps", "kmh",   "fps", "kmph",    "kn",  "kt",   "kts",   "knots",
    "deg", "degs", "degps", "dps", "degrees", "rad", "rads", "radps", "rpm"};
constexpr std::string_view kForceUnits[] = {"n",
                                            "kn",
                                            "mn",
                                            "nm",
                                            "knm",
                                            "mnm",
                                            "lbf",
                                            "kgf",
                                            "kg",
                                            "ncm",
                                            "a",
                                            "ma",
                                            "pwm",
                                            "percent",
                                            "pct"};
constexpr std::string_view kSpeedUnits[] = {
    "hz", "khz", "rpm", "rps", "rads", "radps", "us", "percent", "pct", "pwm"};

std::span<const std::string_view> UnitsOf(std::string_view name) {
  if (name == "t") return kTimeUnits;
  if (name.starts_with("tau")) return kForceUnits;
  if (name.starts_with("thruster")) return kSpeedUnits;
  return kMotionUnits;
}

std::string LowerCase(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower;
}

// "_cm/s" -> "cms", " [m s^-1]" -> "ms1".
std::string LettersOf(std::string_view text) {
  std::string letters;
  for (const char c : text) {
    if (std::isalnum(static_cast<unsigned char>(c))) letters += c;
  }
  return letters;
}

bool IsUnit(std::string_view suffix, std::string_view name) {
  const std::size_t first = suffix.find_first_not_of("_ -.");
  if (first != std::string_view::npos && (suffix[first] == '[' || suffix[first] == '('))
    return true;
  if (std::string_view("_ -.").find(suffix.front()) == std::string_view::npos) return false;
  const auto units = UnitsOf(name);
  return std::find(units.begin(), units.end(), LettersOf(suffix)) != units.end();
}

}  // namespace

std::optional<std::string> NameWithoutUnit(std::string_view column,
                                           const std::vector<std::string>& known_names) {
  const std::string lower = LowerCase(column);
  for (const std::string& name : known_names) {
    std::vector<std::string> words = {name};
    if (name == "t") words.insert(words.end(), {"timestamp", "time", "stamp"});
    for (const std::string& word : words) {
      if (!lower.starts_with(word)) continue;
      const std::string_view suffix = std::string_view(lower).substr(word.size());
      if (suffix.empty() ? word != name : IsUnit(suffix, name)) return name;
    }
  }
  return std::nullopt;
}

}  // namespace fathom
