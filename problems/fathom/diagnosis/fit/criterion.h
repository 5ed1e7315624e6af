// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <limits>

namespace fathom {

// What a fit takes its residual for, and is weighed by.
enum class Criterion {
  kLearnedNoise,  // sensor noise and disturbance, learned along: of least variance if nothing is
                  // missing, but what is missing passes for a disturbance where it can
  kFreeRun,       // white noise, as large in each channel as what the free run misses of it: output
                  // error's own
};

// When a search has arrived. By default, a tenth of a standard deviation from the end.
struct FitPrecision {
  double gain = 0.01;  // of chi squared, that a step has to promise
  double share = 0.0;  // of what is left of chi squared, likewise
  double turn = 0.1;   // of the log-likelihood, that a turn of noise and parameters has to gain

  // The log-likelihood below which no further turn is taken.
  double least = -std::numeric_limits<double>::infinity();
};

}  // namespace fathom
