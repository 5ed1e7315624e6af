// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/options.h"

#include <fmt/format.h>

namespace fathom {

std::vector<std::string> DiagnosisOptions::Problems() const {
  std::vector<std::string> problems;
  if (!(false_alarm_rate > 0.0 && false_alarm_rate <= 0.5)) {
    problems.push_back(
        fmt::format("false_alarm_rate is {}, expected a number in (0, 0.5].", false_alarm_rate));
  }
  if (most_causes < 1 || most_causes > 3) {
    problems.push_back(fmt::format("most_causes is {}, expected 1 to 3.", most_causes));
  }
  if (!(effort > 0.0)) {
    problems.push_back(fmt::format("effort is {}, expected a number above 0.", effort));
  }
  if (!(separation >= 0.0)) {
    problems.push_back(
        fmt::format("separation is {}, expected a number of at least 0.", separation));
  }
  return problems;
}

}  // namespace fathom
