// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/trends/event_fit.h"

#include "fathom/solve/decompositions.h"

#include <Eigen/Cholesky>

namespace fathom {
namespace {

constexpr double kLeastShareOfItsOwn = 1e-6;

// One series in the joint fit.
struct Part {
  std::vector<Column> columns;  // the event's last, if the series shows it
  bool shows_event = false;
  int first_coefficient = 0;
  Eigen::MatrixXd design;  // dives by 1 + columns
};

bool HasFullRank(const Eigen::MatrixXd& design) {
  return RankOf(design, kLeastShareOfItsOwn) == design.cols() && design.rows() > design.cols();
}

Part PartOf(const DiveSeries& series,
            int s,
            std::span<const EventColumn> events,
            std::size_t index,
            int num_dives) {
  Part part;
  const auto with = [&](const Column& column) {
    std::vector<Column> columns = part.columns;
    columns.push_back(column);
    return columns;
  };
  for (std::size_t e = 0; e < events.size(); ++e) {
    if (e == index || !events[e].moves[s]) continue;
    const std::vector<Column> columns = with(events[e].column);
    if (HasFullRank(DesignMatrix(series, columns, num_dives))) part.columns = columns;
  }
  const std::vector<Column> columns = with(events[index].column);
  part.shows_event = HasFullRank(DesignMatrix(series, columns, num_dives));
  if (part.shows_event) part.columns = columns;
  part.design = DesignMatrix(series, part.columns, num_dives);
  return part;
}

// Everything in the series as it is just before the event.
Eigen::VectorXd RowBefore(const Part& part, const Column& event, int first_dive, int num_dives) {
  const int at = event.kind == ChangeKind::kStep ? event.at : first_dive;
  Eigen::VectorXd row = Eigen::VectorXd::Ones(1 + part.columns.size());
  for (std::size_t c = 0; c < part.columns.size(); ++c) {
    row(1 + c) = ColumnAt(part.columns[c], at, num_dives);
  }
  const bool is_step = event.kind == ChangeKind::kStep;
  row(row.size() - 1) = is_step ? 0.0 : ColumnAt(event, first_dive, num_dives);
  return row;
}

}  // namespace

EventFit FitEvent(std::span<const DiveSeries> series,
                  std::span<const DiveBlock> blocks,
                  std::span<const double> tau_squared,
                  std::span<const EventColumn> events,
                  std::size_t index,
                  int num_dives) {
  std::vector<Part> parts;
  int size = 0;
  EventFit fit;
  for (std::size_t s = 0; s < series.size(); ++s) {
    parts.push_back(PartOf(series[s], static_cast<int>(s), events, index, num_dives));
    parts.back().first_coefficient = size;
    size += static_cast<int>(parts.back().design.cols());
    if (parts.back().shows_event) fit.series.push_back(static_cast<int>(s));
  }

  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(size);
  for (const DiveBlock& block : blocks) {
    const Eigen::Index rows = static_cast<Eigen::Index>(block.series.size());
    Eigen::MatrixXd covariance = block.covariance;
    for (Eigen::Index i = 0; i < rows; ++i) covariance(i, i) += tau_squared[block.series[i]];
    const Eigen::MatrixXd weight = covariance.llt().solve(Eigen::MatrixXd::Identity(rows, rows));
    for (Eigen::Index i = 0; i < rows; ++i) {
      const Part& a = parts[block.series[i]];
      const auto row = a.design.row(block.element[i]);
      for (Eigen::Index j = 0; j < rows; ++j) {
        const Part& b = parts[block.series[j]];
        information.block(
            a.first_coefficient, b.first_coefficient, a.design.cols(), b.design.cols()) +=
            weight(i, j) * row.transpose() * b.design.row(block.element[j]);
        right.segment(a.first_coefficient, a.design.cols()) +=
            weight(i, j) * series[block.series[j]].value(block.element[j]) * row.transpose();
      }
    }
  }
  const Eigen::LDLT<Eigen::MatrixXd> factor(information);
  const Eigen::VectorXd coefficients = factor.solve(right);

  const Eigen::Index m = static_cast<Eigen::Index>(fit.series.size());
  Eigen::MatrixXd pick = Eigen::MatrixXd::Zero(2 * m, size);
  for (Eigen::Index i = 0; i < m; ++i) {
    const Part& part = parts[fit.series[i]];
    const DiveSeries& one = series[fit.series[i]];
    const Column& column = events[index].column;
    const Eigen::Index columns = part.design.cols();
    pick.row(i).segment(part.first_coefficient, columns) =
        RowBefore(part, column, one.dive.front(), num_dives).transpose();
    // A trend over the dives of the archive, first to last.
    pick(m + i, part.first_coefficient + columns - 1) = 1.0;
  }
  const Eigen::VectorXd picked = pick * coefficients;
  fit.before = picked.head(m);
  fit.difference = picked.tail(m);
  fit.covariance = pick * factor.solve(pick.transpose());
  return fit;
}

}  // namespace fathom
