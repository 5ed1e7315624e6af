// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/window_scores.h"

#include "fathom/base/parallel_for.h"

#include <atomic>
#include <cmath>
#include <cstddef>
#include <map>

namespace fathom {

namespace {

// Of one window.
bool ScoresOfWindow(const WindowProblem& problem,
                    const std::vector<ChannelWeight>& weights,
                    const WindowPoint& point,
                    double block,
                    std::size_t w,
                    WindowScores* scores) {
  const auto num = static_cast<Eigen::Index>(problem.entries.size());
  const Eigen::Index m = problem.free.size();
  thread_local WindowResiduals residuals;  // megabytes, for many windows of the same size
  if (!ResidualsIn(problem, point, w, true, &residuals)) return false;
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(num + m, num + m);
  for (WindowResiduals::Piece& piece : residuals.pieces) {
    WeighRows(weights[piece.channel], &piece);
    gram.selfadjointView<Eigen::Lower>().rankUpdate(piece.rows.rightCols(num + m).transpose());
  }
  gram = gram.selfadjointView<Eigen::Lower>();
  const Eigen::MatrixXd st = gram.bottomLeftCorner(m, num);
  const Eigen::MatrixXd by = StartSolver(gram.bottomRightCorner(m, m), 0.0).solve(st);
  scores->normal = gram.topLeftCorner(num, num) - st.transpose() * by;
  // Sums over the blocks, of all columns; then the starts go.
  std::map<long, Eigen::VectorXd> by_block;
  const CoupledWindow& window = problem.windows[w];
  const double first = window.segment->time[window.samples.begin];
  for (const WindowResiduals::Piece& piece : residuals.pieces) {
    for (Eigen::Index i = 0; i < piece.rows.rows(); ++i) {
      const double t = piece.time[static_cast<std::size_t>(i)];
      const auto at = static_cast<long>(std::floor((t - first) / block));
      Eigen::VectorXd& sum = by_block[at];
      if (sum.size() == 0) sum.setZero(num + m);
      sum.transpose() += piece.rows(i, 0) * piece.rows.row(i).tail(num + m);
    }
  }
  scores->by_block.resize(static_cast<Eigen::Index>(by_block.size()), num);
  Eigen::Index row = 0;
  for (const auto& [at, sum] : by_block) {
    scores->by_block.row(row++) = (sum.head(num) - by.transpose() * sum.tail(m)).transpose();
  }
  return true;
}

}  // namespace

bool ScoresOf(const WindowProblem& problem,
              const std::vector<ChannelWeight>& weights,
              const WindowPoint& point,
              double block,
              WindowScores* scores) {
  const auto num = static_cast<Eigen::Index>(problem.entries.size());
  std::vector<WindowScores> of(problem.windows.size());
  std::atomic<bool> runs = true;
  ParallelFor(static_cast<int>(of.size()), [&](int w) {
    const auto window = static_cast<std::size_t>(w);
    if (runs && !ScoresOfWindow(problem, weights, point, block, window, &of[window])) runs = false;
  });
  if (!runs) return false;
  Eigen::Index num_blocks = 0;
  for (const WindowScores& window : of) num_blocks += window.by_block.rows();
  scores->normal = Eigen::MatrixXd::Zero(num, num);
  scores->by_block.resize(num_blocks, num);
  Eigen::Index row = 0;
  for (const WindowScores& window : of) {
    scores->normal += window.normal;
    scores->by_block.middleRows(row, window.by_block.rows()) = window.by_block;
    row += window.by_block.rows();
  }
  return true;
}

}  // namespace fathom
