// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/coupled_fit_options.h"

#include <fmt/format.h>

namespace fathom {

std::vector<std::string> CoupledFitOptions::Problems() const {
  std::vector<std::string> problems;
  if (!(window > 0.0))
    problems.push_back(fmt::format("window is {} s, expected more than 0", window));
  if (!(huber_k > 0.0))
    problems.push_back(fmt::format("huber_k is {}, expected more than 0", huber_k));
  if (max_iterations < 1) {
    problems.push_back(fmt::format("max_iterations is {}, expected at least 1", max_iterations));
  }
  return problems;
}

CoupledFitOptions BegunAt(const CoupledSummary& fit, CoupledFitOptions options) {
  options.start = fit.model;
  options.noise = fit.noise;
  options.priors = fit.priors;
  return options;
}

}  // namespace fathom
