// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

namespace fathom {

// Gains of the adaptive law, docs/adaptive.md (1) and (2).
struct AdaptiveGains {
  double a_m = std::numeric_limits<double>::quiet_NaN();  // [1/s], below 0

  // Lambda, of alpha, beta, mu and nu in this order; above 0.
  std::array<double, 4> lambda = {std::numeric_limits<double>::quiet_NaN(),
                                  std::numeric_limits<double>::quiet_NaN(),
                                  std::numeric_limits<double>::quiet_NaN(),
                                  std::numeric_limits<double>::quiet_NaN()};

  // Every broken rule, a sentence each; empty if the gains can be used.
  std::vector<std::string> Problems() const;
};

// "a_m,l1,l2,l3,l4", as --gains takes them: the same numbers to the last digit.
std::string FormatGains(const AdaptiveGains& gains);

}  // namespace fathom
