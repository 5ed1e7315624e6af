// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/trends/column.h"

#include <algorithm>

namespace fathom {

double ColumnAt(const Column& column, int dive, int num_dives) {
  if (column.kind == ChangeKind::kStep) return dive >= column.at ? 1.0 : 0.0;
  return static_cast<double>(dive) / std::max(num_dives - 1, 1);
}

Eigen::MatrixXd DesignMatrix(const DiveSeries& series,
                             std::span<const Column> columns,
                             int num_dives) {
  const Eigen::Index rows = static_cast<Eigen::Index>(series.dive.size());
  Eigen::MatrixXd design = Eigen::MatrixXd::Ones(rows, 1 + columns.size());
  for (Eigen::Index i = 0; i < rows; ++i) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      design(i, 1 + c) = ColumnAt(columns[c], series.dive[i], num_dives);
    }
  }
  return design;
}

}  // namespace fathom
