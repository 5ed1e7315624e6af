// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/simulate/free_run.h"

#include <span>

namespace fathom {

// The variance of what scatters from sample to sample in the misses e of free runs, by the median
// size of second differences, whose variance is six times that of white noise; docs/diagnosis.md
// (13):
//
//   sigma = 1.4826 median |e_(i-1) - 2 e_i + e_(i+1)| / sqrt(6)
//
// Noise that wanders, as that of a filtered sensor, counts less than it is. NaN for fewer than
// three samples in a row.
double ScatterVariance(std::span<const FreeRun> runs);

// The NMAE that scatter from sample to sample alone gives, as an estimate; docs/diagnosis.md (14):
//
//   mean |e_(i-1) - 2 e_i + e_(i+1)| / (sqrt(6) mean |measured|)
//
// White noise of normal distribution is assumed. NaN where nothing was measured, or fewer than
// three samples in a row.
double NmaeOfScatter(std::span<const FreeRun> runs);

// From so many times that on, a model misses some of the motion.
inline constexpr double kMuchMoreThanScatter = 3.0;

}  // namespace fathom
