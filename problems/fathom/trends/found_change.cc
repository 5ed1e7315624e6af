// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/trends/found_change.h"

#include "fathom/solve/decompositions.h"

#include <cmath>

namespace fathom {
namespace {

// All columns as they are at `at`, but `column` as it is at `own_at`.
Eigen::VectorXd RowAt(
    std::span<const Column> columns, std::size_t column, int at, int own_at, int num_dives) {
  Eigen::VectorXd row = Eigen::VectorXd::Ones(1 + columns.size());
  for (std::size_t c = 0; c < columns.size(); ++c) {
    row(1 + c) = ColumnAt(columns[c], c == column ? own_at : at, num_dives);
  }
  return row;
}

}  // namespace

Change ChangeOf(const SeriesModel& model,
                std::size_t found_index,
                double tau_squared,
                int num_dives) {
  const DiveSeries& series = model.series;
  const std::vector<Column> columns = AllColumns(model);
  const std::size_t index = model.known.size() + found_index;
  const Column& column = columns[index];
  const Eigen::VectorXd root_weight = (series.variance.array() + tau_squared).rsqrt();
  const Eigen::MatrixXd design =
      root_weight.asDiagonal() * DesignMatrix(series, columns, num_dives);
  const Eigen::MatrixXd inverse = PseudoInverse(design);
  const Eigen::VectorXd coefficients = inverse * root_weight.cwiseProduct(series.value);

  const bool is_step = column.kind == ChangeKind::kStep;
  const int at = is_step ? column.at : series.dive.front();
  const int before_at = is_step ? column.at - 1 : series.dive.front();
  const int after_at = is_step ? column.at : series.dive.back();
  const Eigen::VectorXd before = RowAt(columns, index, at, before_at, num_dives);
  const Eigen::VectorXd after = RowAt(columns, index, at, after_at, num_dives);

  Change change;
  change.dof = series.dof;
  change.parameter = series.parameter;
  change.entry = series.entry;
  change.kind = column.kind;
  change.at = column.at;
  change.before = series.scale * before.dot(coefficients);
  change.after = series.scale * after.dot(coefficients);
  change.before_std = series.scale * (before.transpose() * inverse).norm();
  change.after_std = series.scale * (after.transpose() * inverse).norm();
  change.p_value = model.found[found_index].p_value;
  return change;
}

}  // namespace fathom
