// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/trends/column.h"
#include "fathom/trends/scan.h"
#include "fathom/trends/series.h"

#include <vector>

namespace fathom {

// A change of one series and the p-value that it came in with.
struct FoundColumn {
  Column column;
  double p_value = 1.0;
};

// What is said of one series so far.
struct SeriesModel {
  DiveSeries series;               // without its outliers
  std::vector<Column> known;       // stay as they are
  std::vector<FoundColumn> found;  // in the order in which they came
};

// `known`, then `found`.
std::vector<Column> AllColumns(const SeriesModel& model);

// The model once each of its found columns has been tried again: a column goes whose statistic
// beside the others is below `threshold`, moves to the place or kind that has a larger one, and two
// steps give way to a trend that is less likely than both by less than `threshold`.
SeriesModel Reconsidered(SeriesModel model, double threshold, int num_dives);

}  // namespace fathom
