// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/judged_fit.h"

#include "fathom/base/median.h"
#include "fathom/coupled/channel_noise.h"
#include "fathom/coupled/open_entries.h"
#include "fathom/coupled/physical_barrier.h"
#include "fathom/coupled/window_scores.h"
#include "fathom/solve/decompositions.h"
#include "fathom/vehicle/coupled/entry_name.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

constexpr double kShortestBlock = 1.0;   // [s] of the scores' blocks
constexpr double kBlocksOfEntry = 4.0;   // at least, for each number that is free
constexpr double kFewestOfBlock = 10.0;  // samples

// As long as leaves enough of them: what is left of the noise's colour stays within a block.
double BlockLength(const std::vector<CoupledWindow>& windows, std::size_t num_entries) {
  double total = 0.0, longest = 0.0;
  for (const CoupledWindow& window : windows) {
    const std::vector<double>& time = window.segment->time;
    const double length = time[window.samples.end - 1] - time[window.samples.begin];
    total += length;
    longest = std::max(longest, length);
  }
  const double step = MedianStep(windows.front().segment->time);
  const double enough = total / (kBlocksOfEntry * static_cast<double>(num_entries));
  return std::max({kShortestBlock, kFewestOfBlock * step, std::min(enough, longest)});
}

// Of the entries: what white innovations say, widened where the scores scatter more.
Eigen::MatrixXd CovarianceOf(const WindowScores& at, int num_rows, int num_unknowns) {
  const Eigen::MatrixXd& scores = at.by_block;
  const Eigen::MatrixXd inverse = InverseOfSymmetric(at.normal);
  const double freedom = std::max(num_rows - num_unknowns, 1);
  const Eigen::MatrixXd model = inverse * (num_rows / freedom);
  if (scores.rows() <= scores.cols()) return model;
  const double blocks = static_cast<double>(scores.rows());
  const double few = blocks / (blocks - static_cast<double>(scores.cols())) * num_rows / freedom;
  const Eigen::MatrixXd sandwich = few * inverse * (scores.transpose() * scores) * inverse;
  Eigen::VectorXd wider(model.rows());
  for (Eigen::Index k = 0; k < model.rows(); ++k) {
    wider[k] = std::sqrt(std::max(sandwich(k, k) / model(k, k), 1.0));
  }
  return wider.asDiagonal() * model * wider.asDiagonal();
}

std::string NamesOf(const std::vector<FreeEntry>& entries) {
  std::vector<std::string> names;
  for (const FreeEntry& entry : entries) names.push_back(NameOf(entry));
  return fmt::format("{}", fmt::join(names, ", "));
}

// The scores where the fit has ended, what the priors tell among the normal equations. False if the
// simulation diverges.
bool ScoresAtEnd(const WindowProblem& problem,
                 const CoupledSummary& summary,
                 double huber_k,
                 WindowScores* scores) {
  const double block = BlockLength(problem.windows, problem.entries.size());
  const WindowPoint end = {summary.model, summary.starts};
  if (!ScoresOf(problem, WeightsOf(summary.noise, huber_k), end, block, scores)) return false;
  scores->normal += OfPriors(problem, summary.model);
  return true;
}

int NumUnknowns(const WindowProblem& problem) {
  return static_cast<int>(problem.entries.size()) +
         problem.free.size() * static_cast<int>(problem.windows.size());
}

// Determined, unless entries trade against each other.
CoupledSummary WithTrades(CoupledSummary summary, const Eigen::MatrixXd& normal) {
  summary.undetermined = UndeterminedIn(normal, summary.entries);
  summary.determined = summary.undetermined.empty();
  if (summary.determined) return summary;
  summary.open_inertias = OpenBesideTheBestTold(summary, normal);
  summary.message = fmt::format("the data do not tell {} apart", NamesOf(summary.undetermined));
  return summary;
}

// Those that nothing holds above 0: the dry mass, where it is known, does.
std::vector<FreeEntry> NotHeldByTheBody(const std::vector<FreeEntry>& inertias,
                                        const RigidBody& body) {
  const Matrix6 known = KnownInertia(body);
  std::vector<FreeEntry> open;
  std::ranges::copy_if(inertias, std::back_inserter(open), [&](const FreeEntry& entry) {
    return !(known(Index(entry.row), Index(entry.row)) > 0.0);
  });
  return open;
}

// Determined, unless inertias may be 0. With the covariance.
CoupledSummary WithOpenInertias(CoupledSummary summary, const RigidBody& body) {
  summary.open_inertias = InertiasThatMayBe0(summary);
  summary.undetermined = NotHeldByTheBody(summary.open_inertias, body);
  summary.determined = summary.undetermined.empty();
  if (summary.determined) return summary;
  summary.message =
      fmt::format("the data allow 0 for {}: drive these DOFs harder, or leave them out of --dofs",
                  NamesOf(summary.undetermined));
  return summary;
}

}  // namespace

CoupledSummary Judged(CoupledSummary summary, const WindowProblem& problem, double huber_k) {
  WindowScores scores;
  if (!ScoresAtEnd(problem, summary, huber_k, &scores)) {
    summary.message = "the simulation diverges";
    return summary;
  }
  summary = WithTrades(std::move(summary), scores.normal);
  if (!summary.determined) return summary;
  summary.covariance = CovarianceOf(scores, summary.num_rows, NumUnknowns(problem));
  summary = WithOpenInertias(std::move(summary), problem.body);
  if (!summary.determined) return summary;
  summary.on_bound = OnBound(summary, problem.body);
  summary.message = "converged";
  return summary;
}

}  // namespace fathom
