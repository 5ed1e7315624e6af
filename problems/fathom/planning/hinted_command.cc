// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/hinted_command.h"

#include <algorithm>
#include <cmath>

namespace fathom {
namespace {

constexpr double kShortestHinted = 60.0;  // [s]
constexpr double kLongestHinted = 300.0;

}  // namespace

double HintedDuration(double log_duration) {
  return std::clamp(10.0 * std::round(0.1 * log_duration), kShortestHinted, kLongestHinted);
}

}  // namespace fathom
