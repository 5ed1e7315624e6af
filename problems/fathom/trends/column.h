// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/trends/change.h"
#include "fathom/trends/series.h"

#include <span>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// How a change moves a series: docs/archive_trends.md (2).
struct Column {
  ChangeKind kind = ChangeKind::kStep;
  int at = 0;  // the first dive after a step

  bool operator==(const Column&) const = default;
};

// A step is 0 before `at` and 1 from it on; a trend goes from 0 at the first dive of the archive to
// 1 at the last.
double ColumnAt(const Column& column, int dive, int num_dives);

// The dives of a series by 1 + columns.size(): a column of ones, then the columns.
Eigen::MatrixXd DesignMatrix(const DiveSeries& series,
                             std::span<const Column> columns,
                             int num_dives);

}  // namespace fathom
