// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fathom {

// How much samples that stand a lag apart agree, from the first lag on.
struct Autocorrelation {
  std::vector<double> lag;    // [s]
  std::vector<double> value;  // -1 to 1
  std::vector<double> bound;  // of white noise 95 % of the values stay within it, either side of 0
};

// Of a residual over segments that are pooled, no product taken across their ends:
//
//   r_k = sum_i e_i e_{i+k} / sum_i e_i^2                                    docs/signal.md (10)
//
//   e   residual; its mean is not taken off: a model that leaves one leaves something
//   k   lag in samples, 1 to `most_lags`, and no more than a quarter of the longest segment
//
// The lag in seconds is k times `step`, the median step [s], above 0: stamps count as equally
// spaced. Empty where the residual is 0 everywhere or no segment has four samples.
Autocorrelation AutocorrelationOf(std::span<const std::vector<double>> residuals,
                                  double step,
                                  std::size_t most_lags);

}  // namespace fathom
