// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/fin_check.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <fmt/format.h>

namespace fathom {

std::vector<Finding> CheckFins(const Log& log) {
  std::vector<Finding> findings;
  if (!log.fins) return findings;
  for (std::size_t k = 0; k < log.fins->columns.size(); ++k) {
    double largest = 0.0;
    for (const double angle : log.fins->values[k]) largest = std::max(largest, std::abs(angle));
    if (largest <= std::numbers::pi / 2.0) continue;
    findings.push_back({Severity::kWarning,
                        "fin_angle",
                        fmt::format("command.csv: {} goes to {:.3g}, and angles are in radians: a "
                                    "fin turns by less than a right angle. Is it in degrees?",
                                    log.fins->columns[k],
                                    largest)});
  }
  return findings;
}

}  // namespace fathom
