// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/coupled_fit.h"

#include "fathom/base/input_error.h"
#include "fathom/base/median.h"
#include "fathom/base/robust_std.h"
#include "fathom/coupled/momentum_start.h"
#include "fathom/coupled/open_entries.h"
#include "fathom/coupled/physical_barrier.h"
#include "fathom/coupled/window_scores.h"
#include "fathom/coupled/window_search.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>

#include <Eigen/Dense>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

constexpr int kMostPasses = 5;
constexpr double kShortRun = 0.25;  // of the window's length
constexpr int kMostOrder = 12;      // of a channel's noise
constexpr double kQuietest = 1e-4;  // the least noise of a channel, of what it shows in a second
constexpr double kRoughPrecision = 0.1;  // of the passes before the last, in standard deviations
constexpr double kFinePrecision = 0.02;
constexpr double kRoughGain = 1e-4;  // of the cost: a gain that ends a pass under white noise
constexpr double kDampingNearTheEnd = 1e-6;
constexpr double kAstray = 2.0;          // times the squares that white noise leaves
constexpr double kSettled = 0.1;         // a pass that moves no entry further is the last
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

// A robust standard deviation.
double SpreadOf(std::vector<double> values) {
  if (values.empty()) return 1.0;
  for (double& value : values) value = std::abs(value);
  return RobustStd(std::move(values));
}

std::vector<std::vector<double>> PiecesOf(const std::vector<WindowResiduals>& residuals,
                                          std::size_t channel) {
  std::vector<std::vector<double>> pieces;
  for (const WindowResiduals& window : residuals) {
    for (const WindowResiduals::Piece& piece : window.pieces) {
      if (piece.channel == channel) {
        const Eigen::VectorXd residual = piece.rows.col(0);
        pieces.emplace_back(residual.data(), residual.data() + residual.size());
      }
    }
  }
  return pieces;
}

// The white noise that a sensor has at the least, channel by channel. Of data of a simulation
// without noise only rounding and integration are left, and would pass for structure.
std::vector<double> QuietestSensors(const WindowProblem& problem) {
  Vector6 squares = Vector6::Zero(), num = Vector6::Zero();
  for (const CoupledWindow& window : problem.windows) {
    for (std::size_t i = window.samples.begin; i < window.samples.end; ++i) {
      const Vector6& velocity = window.segment->velocity[i];
      for (Eigen::Index row = 0; row < 6; ++row) {
        if (!std::isfinite(velocity[row])) continue;
        squares[row] += velocity[row] * velocity[row];
        num[row] += 1.0;
      }
    }
  }
  const Vector6 square = squares.cwiseQuotient(num.cwiseMax(1.0));
  std::vector<double> quietest;
  for (const FittedChannel& channel : problem.channels) {
    const bool is_position = channel.kind == FittedChannel::Kind::kPosition;
    const double speed = std::sqrt(is_position ? square.head<3>().sum() : square[channel.row]);
    quietest.push_back(std::max(kQuietest * speed, 1e-12));
  }
  return quietest;
}

// What the residuals look like: white of their spread, or coloured, and white where they are
// quieter than any sensor. Wild ones are cut to five standard deviations before their colour is
// learned.
std::vector<ChannelNoise> NoiseOf(const std::vector<WindowResiduals>& residuals,
                                  const std::vector<FittedChannel>& channels,
                                  const std::vector<double>& quietest,
                                  bool is_white) {
  std::vector<ChannelNoise> noise;
  for (std::size_t c = 0; c < channels.size(); ++c) {
    std::vector<std::vector<double>> pieces = PiecesOf(residuals, c);
    std::vector<double> all;
    for (const auto& piece : pieces) all.insert(all.end(), piece.begin(), piece.end());
    const double spread = SpreadOf(all);
    const double std = std::max(spread, quietest[c]);
    Autoregression colour = {{}, std * std};
    if (!is_white && spread > quietest[c]) {
      for (auto& piece : pieces) {
        for (double& value : piece) value = std::clamp(value, -5.0 * std, 5.0 * std);
      }
      colour = FitAutoregression(std::move(pieces), kMostOrder);
      if (!(colour.innovation_variance > 0.0)) colour = {{}, std * std};
    }
    noise.push_back({channels[c], RowWhitener(colour)});
  }
  return noise;
}

// Whether a noise is one of these channels, in their order.
bool IsOf(const std::vector<ChannelNoise>& noise, const std::vector<FittedChannel>& channels) {
  return std::ranges::equal(noise, channels, {}, &ChannelNoise::channel);
}

std::vector<ChannelWeight> WeightsOf(const std::vector<ChannelNoise>& noise, double huber_k) {
  std::vector<ChannelWeight> weights;
  for (const ChannelNoise& channel : noise) weights.push_back({channel.whitener, huber_k});
  return weights;
}

// Of the entries: what white innovations say, widened where the scores scatter more.
Eigen::MatrixXd CovarianceOf(const WindowScores& at, int num_rows, int num_unknowns) {
  const Eigen::MatrixXd& scores = at.by_block;
  const Eigen::MatrixXd inverse =
      at.normal.ldlt().solve(Eigen::MatrixXd::Identity(at.normal.rows(), at.normal.cols()));
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

double LargestMove(const CoupledModel& from,
                   const CoupledModel& to,
                   const std::vector<FreeEntry>& entries,
                   const Eigen::MatrixXd& normal) {
  Eigen::VectorXd move(static_cast<Eigen::Index>(entries.size()));
  for (std::size_t k = 0; k < entries.size(); ++k) {
    move[static_cast<Eigen::Index>(k)] = ValueIn(to, entries[k]) - ValueIn(from, entries[k]);
  }
  return std::sqrt(std::max(move.dot(normal * move), 0.0));
}

// What residuals cost where they are weighed so.
double CostUnder(const std::vector<ChannelWeight>& weights,
                 std::vector<WindowResiduals> residuals) {
  double cost = 0.0;
  for (WindowResiduals& window : residuals) {
    for (WindowResiduals::Piece& piece : window.pieces) {
      cost += WeighRows(weights[piece.channel], &piece);
    }
  }
  return cost;
}

// A model, and the starts that were measured.
WindowPoint StartOf(const WindowProblem& problem, const CoupledModel& model) {
  WindowPoint point = {model, {}};
  for (const CoupledWindow& window : problem.windows) point.starts.push_back(window.start);
  return point;
}

// The guess brought nearer by runs of a quarter of the window's length, under white noise: long
// runs of a poor guess have many valleys. As it was where that leads nowhere.
CoupledModel BroughtNearer(const CoupledModel& guess,
                           std::span<const CoupledData> logs,
                           const CoupledFitOptions& options,
                           WindowProblem problem) {
  problem.windows = CoupledWindowsOf(logs, kShortRun * options.window);
  const WindowPoint point = StartOf(problem, guess);
  std::vector<WindowResiduals> residuals;
  if (!AllResiduals(problem, point, &residuals)) return guess;
  const auto noise = NoiseOf(residuals, problem.channels, QuietestSensors(problem), true);
  WindowSearchOptions with;
  with.max_iterations = options.max_iterations;
  with.precision = kRoughPrecision;
  with.smallest_gain = kRoughGain;
  return SearchWindows(problem, WeightsOf(noise, options.huber_k), point, with).point.model;
}

}  // namespace

std::vector<std::string> CoupledFitOptions::Problems() const {
  std::vector<std::string> problems;
  if (!(window > 0.0))
    problems.push_back(fmt::format("window is {} s, expected more than 0", window));
  if (!(huber_k > 0.0))
    problems.push_back(fmt::format("huber_k is {}, expected more than 0", huber_k));
  if (max_iterations < 1) {
    problems.push_back(fmt::format("max_iterations is {}, expected at least 1", max_iterations));
  }
  return problems;
}

namespace {

CoupledSummary FitWithPriors(std::span<const CoupledData> logs,
                             const MotionStructure& structure,
                             const CoupledFitOptions& options) {
  if (const auto problems = options.Problems(); !problems.empty()) {
    throw InputError("CoupledFitOptions: " + problems.front() + ".");
  }
  CoupledSummary summary;
  summary.entries = structure.entries;
  std::ranges::copy_if(
      options.priors, std::back_inserter(summary.priors), [&](const EntryPrior& prior) {
        return std::ranges::count(structure.entries, prior.entry) > 0;
      });
  const auto size = static_cast<Eigen::Index>(structure.entries.size());
  summary.covariance =
      Eigen::MatrixXd::Constant(size, size, std::numeric_limits<double>::quiet_NaN());
  WindowProblem problem;
  problem.windows = CoupledWindowsOf(logs, options.window);
  problem.entries = structure.entries;
  problem.channels = ChannelsOf(logs);
  problem.free = FreeStartOf(logs, problem.channels);
  problem.body = options.body;
  problem.priors = summary.priors;
  if (problem.windows.empty()) {
    summary.message = "nothing is left to train on: the held-out intervals take all of the data";
    return summary;
  }
  CoupledModel guess;
  if (options.start) {
    guess = *options.start;
    guess.dofs = structure.dofs;
    guess.coriolis = structure.coriolis;
    const Vector6 least = Vector6::Constant(1e-9);
    guess = MovedInside(guess, structure.entries, options.body, least, least, least);
  } else {
    guess = MomentumStart(logs, structure, options.held, options.body);
    guess = BroughtNearer(guess, logs, options, problem);
  }
  WindowPoint point = StartOf(problem, guess);
  if (options.window_starts.size() == problem.windows.size()) {
    point.starts = options.window_starts;
  }

  std::vector<WindowResiduals> residuals;
  if (!AllResiduals(problem, point, &residuals)) {
    summary.message = "the first guess diverges";
    summary.model = point.model;
    return summary;
  }
  // White noise first, unless its colour is known; then the colour of what is left, until the
  // numbers stay. A colour with which the search goes astray is given up for what came before it:
  // that of a model that misses much of the motion takes what is missed for noise.
  const std::vector<double> quietest = QuietestSensors(problem);
  const bool is_given = IsOf(options.noise, problem.channels);
  const int num_white = is_given ? 0 : 2;
  std::vector<ChannelWeight> white;
  double white_cost = std::numeric_limits<double>::infinity();
  WindowSearch best;
  for (int pass = 0; pass < kMostPasses; ++pass) {
    const bool is_white = pass < num_white;
    std::vector<ChannelNoise> noise =
        pass == 0 && is_given ? options.noise
                              : NoiseOf(residuals, problem.channels, quietest, is_white);
    WindowSearchOptions with;
    with.max_iterations = options.max_iterations;
    const bool is_rough = is_white || !options.learns_noise;
    with.precision = is_rough ? kRoughPrecision : kFinePrecision;
    if (is_white) with.smallest_gain = kRoughGain;
    if (is_given || pass > num_white) with.first_damping = kDampingNearTheEnd;
    WindowSearch search = SearchWindows(problem, WeightsOf(noise, options.huber_k), point, with);
    summary.num_iterations += search.num_iterations;
    if (!search.converged || !AllResiduals(problem, search.point, &residuals)) {
      summary.message = search.message;
      if (!best.converged) summary.model = search.point.model;
      break;
    }
    if (is_white) {
      white = WeightsOf(noise, options.huber_k);
      white_cost = search.cost;
    } else if (!white.empty() && CostUnder(white, residuals) > kAstray * white_cost) {
      break;
    }
    const double move =
        LargestMove(point.model, search.point.model, structure.entries, search.near.normal);
    point = search.point;
    summary.noise = std::move(noise);
    best = std::move(search);
    if (is_given && !options.learns_noise) break;
    if (!is_white && move < kSettled) break;
  }
  if (!best.converged) {
    std::ranges::copy_if(
        structure.entries, std::back_inserter(summary.open_inertias), IsOwnInertia);
    return summary;
  }
  summary.model = point.model;
  const WindowSearch& search = best;
  summary.converged = true;
  summary.starts = point.starts;
  summary.cost = search.cost;
  summary.num_rows = search.near.num_rows;
  if (!options.learns_noise) {
    summary.determined = true;
    summary.message = "converged";
    return summary;
  }
  WindowScores scores;
  if (!ScoresOf(problem,
                WeightsOf(summary.noise, options.huber_k),
                point,
                BlockLength(problem.windows, structure.entries.size()),
                &scores)) {
    summary.message = "the simulation diverges";
    return summary;
  }
  scores.normal += OfPriors(problem, point.model);
  summary.undetermined = UndeterminedIn(scores.normal, structure.entries);
  summary.determined = summary.undetermined.empty();
  if (!summary.determined) {
    summary.open_inertias = OpenBesideTheBestTold(summary, scores.normal);
    summary.message = fmt::format("the data do not tell {} apart", NamesOf(summary.undetermined));
    return summary;
  }
  const int num_unknowns = static_cast<int>(structure.entries.size()) +
                           problem.free.size() * static_cast<int>(problem.windows.size());
  summary.covariance = CovarianceOf(scores, summary.num_rows, num_unknowns);
  summary.open_inertias = InertiasThatMayBe0(summary);
  // The dry mass, where it is known, holds one above 0.
  const Matrix6 known = KnownInertia(options.body);
  std::ranges::copy_if(
      summary.open_inertias, std::back_inserter(summary.undetermined), [&](const FreeEntry& entry) {
        return !(known(Index(entry.row), Index(entry.row)) > 0.0);
      });
  summary.determined = summary.undetermined.empty();
  if (!summary.determined) {
    summary.message = fmt::format(
        "the data leave room for none of {}: drive these DOFs harder, or "
        "leave them out of --dofs",
        NamesOf(summary.undetermined));
    return summary;
  }
  summary.on_bound = OnBound(summary, options.body);
  summary.message = "converged";
  return summary;
}

}  // namespace

CoupledSummary FitCoupled(std::span<const CoupledData> logs,
                          const MotionStructure& structure,
                          const CoupledFitOptions& options) {
  CoupledSummary fit = FitWithPriors(logs, structure, options);
  const auto priors = InertiasAlike(fit.model, fit.open_inertias, structure.entries);
  if (priors.empty()) return fit;
  CoupledFitOptions again = options;
  again.start = fit.model;
  again.priors.insert(again.priors.end(), priors.begin(), priors.end());
  CoupledSummary held = FitWithPriors(logs, structure, again);
  return held.IsUsable() || !fit.IsUsable() ? held : fit;
}

}  // namespace fathom
