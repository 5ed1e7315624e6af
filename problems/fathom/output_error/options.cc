// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/options.h"

#include <fmt/format.h>

namespace fathom {

std::vector<std::string> OutputErrorOptions::Problems() const {
  std::vector<std::string> problems;
  const auto require_positive = [&](const char* name, double value) {
    if (!(value > 0.0)) {
      problems.push_back(fmt::format("{} is {}, expected a value above 0", name, value));
    }
  };
  require_positive("huber_k", huber_k);
  require_positive("shooting_window", shooting_window);
  require_positive("continuity", continuity);
  require_positive("max_iterations", max_iterations);
  if (initial_guess) require_positive("initial_guess.inertia", initial_guess->inertia);
  return problems;
}

}  // namespace fathom
