// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/trends/column.h"
#include "fathom/trends/series.h"

#include <span>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// Something that happened to the vehicle, and which series it may have moved.
struct EventColumn {
  Column column;
  std::vector<char> moves;  // by series
};

// One event across all series, by weighted least squares of all of them at once.
struct EventFit {
  std::vector<int> series;     // those whose dives show this event apart from the others
  Eigen::VectorXd before;      // in units of the series' scales
  Eigen::VectorXd difference;  // after less before
  Eigen::MatrixXd covariance;  // of (before, difference)
};

// The event `index` with every series free to move, the others as they say: archive_trends.md (7).
// `before` is the last value before a step, the value at the first dive for a trend.
EventFit FitEvent(std::span<const DiveSeries> series,
                  std::span<const DiveBlock> blocks,
                  std::span<const double> tau_squared,
                  std::span<const EventColumn> events,
                  std::size_t index,
                  int num_dives);

}  // namespace fathom
