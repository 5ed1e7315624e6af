// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/simulate/free_run.h"

#include <span>

namespace fathom {

// Free runs of two models over the same samples of one source: velocities or displacements.
struct SourceRuns {
  std::span<const FreeRun> before, after;
};

// What share of the first model's error the second removes, docs/diagnosis.md (12):
//
//   sum (E_before - E_after) / sigma^2  over  sum (E_before - n sigma^2) / sigma^2
//
// with the sums over the sources, E the squared error of a source's free runs, n its samples and
// sigma^2 the variance that scatters from sample to sample, which no model can remove. 0 to 1; NaN
// where the first model's error is no more than that scatter, or nothing was measured.
double ExplainedShare(std::span<const SourceRuns> sources);

}  // namespace fathom
