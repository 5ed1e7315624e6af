// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/trends/change_options.h"

#include <algorithm>
#include <cmath>

namespace fathom {

std::vector<std::string> ChangeOptions::Problems() const {
  std::vector<std::string> problems;
  const auto is_share = [](double rate) { return rate > 0.0 && rate < 1.0; };
  if (!is_share(false_alarm_rate)) problems.push_back("false_alarm_rate must be in (0, 1)");
  if (!is_share(outlier_rate)) problems.push_back("outlier_rate must be in (0, 1)");
  const double needed = 1.0 / std::min(false_alarm_rate, outlier_rate) - 1.0;
  if (problems.empty() && num_draws < std::floor(needed)) {
    problems.push_back("num_draws must be at least 1 / outlier_rate and 1 / false_alarm_rate");
  }
  return problems;
}

}  // namespace fathom
