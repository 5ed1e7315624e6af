// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/entry_test.h"

#include "fathom/base/chi_square.h"
#include "fathom/coupled/window_scores.h"
#include "fathom/solve/decompositions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include <Eigen/Core>

namespace fathom {
namespace {

constexpr double kTestBlock = 1.0;  // [s]

}  // namespace

std::vector<EntryTest> TestEntries(std::span<const CoupledData> logs,
                                   const CoupledSummary& fit,
                                   const std::vector<FreeEntry>& candidates,
                                   const CoupledFitOptions& options) {
  WindowProblem problem;
  problem.windows = CoupledWindowsOf(logs, options.window);
  problem.entries = fit.entries;
  problem.entries.insert(problem.entries.end(), candidates.begin(), candidates.end());
  problem.channels = ChannelsOf(logs);
  problem.free = FreeStartOf(logs, problem.channels);
  problem.priors = fit.priors;
  const WindowPoint point = {fit.model, fit.starts};
  std::vector<ChannelWeight> weights;
  for (const ChannelNoise& noise : fit.noise) weights.push_back({noise.whitener, options.huber_k});
  WindowScores scores;
  if (!ScoresOf(problem, weights, point, kTestBlock, &scores)) return {};

  const auto num_free = static_cast<Eigen::Index>(fit.entries.size());
  const auto num = static_cast<Eigen::Index>(candidates.size());
  scores.normal += OfPriors(problem, fit.model);
  const Eigen::MatrixXd free_normal = scores.normal.topLeftCorner(num_free, num_free);
  const Eigen::MatrixXd cross = scores.normal.topRightCorner(num_free, num);
  const Eigen::MatrixXd by = SolveSymmetricColumns(free_normal, cross);
  // What the free numbers cannot imitate.
  const Eigen::MatrixXd own = scores.normal.bottomRightCorner(num, num) - cross.transpose() * by;
  const Eigen::MatrixXd blocks =
      scores.by_block.rightCols(num) - scores.by_block.leftCols(num_free) * by;
  const Eigen::VectorXd sum = blocks.colwise().sum();
  const double few = static_cast<double>(blocks.rows()) /
                     std::max(1.0, static_cast<double>(blocks.rows() - num_free));
  std::vector<EntryTest> tests;
  for (Eigen::Index c = 0; c < num; ++c) {
    EntryTest& test = tests.emplace_back();
    test.entry = candidates[static_cast<std::size_t>(c)];
    const double own_square = own(c, c);
    if (!(own_square > 1e-9 * scores.normal(num_free + c, num_free + c))) {
      test.likeness.assign(candidates.size(), 0.0);
      continue;  // the model's numbers imitate it
    }
    const double scatter = few * blocks.col(c).squaredNorm();
    test.z = -sum[c] / std::sqrt(std::max(scatter, own_square));
    test.value = -sum[c] / own_square;
    for (Eigen::Index d = 0; d < num; ++d) {
      const double both = std::sqrt(own_square * std::max(own(d, d), 1e-300));
      test.likeness.push_back(own(c, d) / both);
    }
  }
  return tests;
}

double JointPValue(std::span<const EntryTest> tests) {
  constexpr double kImitated = 1e-6;  // of a direction that the others hold already
  const auto num = static_cast<Eigen::Index>(tests.size());
  if (num == 0) return 1.0;
  Eigen::VectorXd z(num);
  Eigen::MatrixXd likeness(num, num);
  for (Eigen::Index k = 0; k < num; ++k) {
    const EntryTest& test = tests[static_cast<std::size_t>(k)];
    z[k] = test.z;
    likeness.row(k) = Eigen::RowVectorXd::Map(test.likeness.data(), num);
  }
  const SymmetricEigen eigen = EigenOf(likeness);
  double chi_squared = 0.0;
  int num_directions = 0;
  for (Eigen::Index k = 0; k < num; ++k) {
    if (!(eigen.values[k] > kImitated)) continue;
    const double along = eigen.vectors.col(k).dot(z);
    chi_squared += along * along / eigen.values[k];
    ++num_directions;
  }
  return ChiSquareTail(chi_squared, num_directions);
}

}  // namespace fathom
