// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fathom {

// The power of a signal over frequency.
struct Spectrum {
  std::vector<double> frequency;  // [Hz], equally spaced, without 0 and half the rate
  std::vector<double> density;    // one-sided [unit^2/Hz]: its integral is the mean square

  // Of white noise of the same mean square 95 % of the densities lie from `low` to `high`; its
  // density is `level` everywhere.
  double level = 0.0, low = 0.0, high = 0.0;
};

// Welch's: the mean of the periodograms of Hann windows that overlap by half, none across the end
// of a segment,
//
//   P(f) = 2 step mean |sum_n w_n e_n exp(-2 pi i f n step)|^2 / sum_n w_n^2  docs/signal.md (11)
//
// `window`: samples of a window, even and 4 or more; `step`: the median step [s], above 0: stamps
// count as equally spaced. Empty where no segment holds a window.
Spectrum SpectrumOf(std::span<const std::vector<double>> residuals,
                    double step,
                    std::size_t window);

}  // namespace fathom
