// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/archive/trends/scan.h"
#include "fathom/archive/trends/series.h"

#include <cstdint>
#include <span>
#include <vector>

namespace fathom {

// The largest statistics of an archive in which nothing further changes, over all its series,
// places and kinds at once.
struct QuietArchive {
  std::vector<double> largest_change;  // of a step or trend, one for each draw
  std::vector<double> largest_dive;    // of a value of its own
};

struct QuietDraws {
  int num_draws = 499;
  std::uint64_t seed = 1;
  // Both statistics of the archive in hand, and how many draws may reach each of them before it is
  // ordinary. The draws end once both are.
  double observed_change = 0.0;
  double observed_dive = 0.0;
  int enough_changes = 499;
  int enough_dives = 499;
};

// Draws archives with the same dives, covariances and scatter between dives. The model's columns
// need not be drawn: every candidate is judged after them. The same seed gives the same draws.
QuietArchive DrawQuietArchives(std::span<const DiveBlock> blocks,
                               std::span<const Series> series,
                               std::span<const ScanDesign> designs,
                               std::span<const double> tau_squared,
                               const QuietDraws& draws);

// (1 + those at least as large) / (1 + draws).
double PValue(std::span<const double> largest, double observed);

// The smallest statistic that would still have a p-value of at most `rate`; infinite where there
// are too few draws for any.
double ThresholdAt(std::vector<double> largest, double rate);

}  // namespace fathom
