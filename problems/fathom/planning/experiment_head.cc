// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/experiment_head.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace fathom {

std::string ExperimentHead(std::string_view name, double duration, double hold) {
  // Whole periods of the command in a cell, ten a second or more.
  const double rate = std::max(1.0, std::ceil(10.0 * hold - 1e-9)) / hold;
  return fmt::format(
      "# Planned by fathom_plan: fathom_synthesize plays the command.csv beside this file.\n"
      "name: {}\n"
      "duration: {}\n"
      "command_rate: {}\n",
      name,
      duration,
      rate);
}

}  // namespace fathom
