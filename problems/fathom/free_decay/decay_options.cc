// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/free_decay/decay_options.h"

#include <fmt/format.h>

namespace fathom {

std::vector<std::string> FreeDecayOptions::Problems() const {
  std::vector<std::string> problems;
  if (!(huber_k > 0.0)) {
    problems.push_back(fmt::format("huber_k is {}, expected above 0", huber_k));
  }
  if (max_noise_order < 0) {
    problems.push_back(fmt::format("max_noise_order is {}, expected at least 0", max_noise_order));
  }
  return problems;
}

}  // namespace fathom
