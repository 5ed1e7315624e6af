// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace fathom {

struct ChangeOptions {
  double false_alarm_rate = 0.05;  // quiet archives with any change, above 0 and below 1
  double outlier_rate = 0.005;  // nominal, of quiet archives with any outlier, above 0 and below 1
  int num_draws = 999;          // of quiet archives, at least 1 / outlier_rate
  std::uint64_t seed = 1;       // of those draws

  // Every rule that is broken.
  std::vector<std::string> Problems() const;
};

}  // namespace fathom
