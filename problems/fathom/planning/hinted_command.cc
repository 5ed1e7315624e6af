// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/hinted_command.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace fathom {
namespace {

constexpr double kShortestHinted = 60.0;  // [s]
constexpr double kLongestHinted = 300.0;

}  // namespace

std::string ShellWord(const std::string& word) {
  constexpr std::string_view kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-./=:@%+,";
  if (word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

double HintedDuration(double log_duration) {
  return std::clamp(10.0 * std::round(0.1 * log_duration), kShortestHinted, kLongestHinted);
}

}  // namespace fathom
