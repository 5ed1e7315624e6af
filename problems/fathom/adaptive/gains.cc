// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/adaptive/gains.h"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {

std::vector<std::string> AdaptiveGains::Problems() const {
  std::vector<std::string> problems;
  if (!(a_m < 0.0) || !std::isfinite(a_m)) {
    problems.push_back(fmt::format("a_m is {}, expected a number below 0", a_m));
  }
  for (size_t k = 0; k < lambda.size(); ++k) {
    if (!(lambda[k] > 0.0) || !std::isfinite(lambda[k])) {
      problems.push_back(fmt::format("l{} is {}, expected a number above 0", k + 1, lambda[k]));
    }
  }
  return problems;
}

std::string FormatGains(const AdaptiveGains& gains) {
  return fmt::format("{},{}", gains.a_m, fmt::join(gains.lambda, ","));
}

}  // namespace fathom
