// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/window_scores.h"

#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

namespace fathom {

bool ScoresOf(const WindowProblem& problem,
              const std::vector<ChannelWeight>& weights,
              const WindowPoint& point,
              double block,
              WindowScores* scores) {
  const auto num = static_cast<Eigen::Index>(problem.entries.size());
  const Eigen::Index m = problem.free.size();
  scores->normal = Eigen::MatrixXd::Zero(num, num);
  std::vector<Eigen::VectorXd> sums;
  for (std::size_t w = 0; w < problem.windows.size(); ++w) {
    WindowResiduals residuals;
    if (!ResidualsIn(problem, point, w, true, &residuals)) return false;
    std::vector<RowMajorRows> all;
    Eigen::MatrixXd ss = Eigen::MatrixXd::Zero(m, m), st = Eigen::MatrixXd::Zero(m, num);
    for (const WindowResiduals::Piece& piece : residuals.pieces) {
      double cost = 0.0;
      const RowMajorRows& rows =
          all.emplace_back(WeighedRows(piece, weights[piece.channel], &cost));
      const auto entries = rows.middleCols(1, num);
      scores->normal.noalias() += entries.transpose() * entries;
      ss.noalias() += rows.rightCols(m).transpose() * rows.rightCols(m);
      st.noalias() += rows.rightCols(m).transpose() * entries;
    }
    const Eigen::MatrixXd by = StartSolver(ss, 0.0).solve(st);
    scores->normal -= st.transpose() * by;
    std::map<long, Eigen::VectorXd> by_block;
    const CoupledWindow& window = problem.windows[w];
    const double first = window.segment->time[window.samples.begin];
    for (std::size_t p = 0; p < all.size(); ++p) {
      const RowMajorRows& rows = all[p];
      for (Eigen::Index i = 0; i < rows.rows(); ++i) {
        const double t = residuals.pieces[p].time[static_cast<std::size_t>(i)];
        const auto at = static_cast<long>(std::floor((t - first) / block));
        auto [sum, is_new] = by_block.try_emplace(at, Eigen::VectorXd::Zero(num));
        sum->second.transpose() +=
            rows(i, 0) * (rows.row(i).segment(1, num) - rows.row(i).tail(m) * by);
      }
    }
    for (auto& [at, sum] : by_block) sums.push_back(std::move(sum));
  }
  scores->by_block.resize(static_cast<Eigen::Index>(sums.size()), num);
  for (std::size_t i = 0; i < sums.size(); ++i) {
    scores->by_block.row(static_cast<Eigen::Index>(i)) = sums[i];
  }
  return true;
}

}  // namespace fathom
