// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/fit_passes.h"

#include "fathom/coupled/channel_noise.h"
#include "fathom/vehicle/coupled/entry_value.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <Eigen/Core>

namespace fathom {
namespace {

constexpr int kMostPasses = 5;
constexpr int kWhitePasses = 2;          // where no noise is given
constexpr double kRoughPrecision = 0.1;  // of the passes before the last, in standard deviations
constexpr double kFinePrecision = 0.02;
constexpr double kRoughGain = 1e-4;  // of the cost: a gain that ends a pass under white noise
constexpr double kDampingNearTheEnd = 1e-6;
constexpr double kAstray = 2.0;   // times the squares that white noise leaves
constexpr double kSettled = 0.1;  // a pass that moves no entry further is the last

// What a pass takes the residuals for.
enum class PassNoise { kGiven, kWhite, kColoured };

PassNoise KindOfNoise(int pass, bool is_given) {
  if (is_given) return pass == 0 ? PassNoise::kGiven : PassNoise::kColoured;
  return pass < kWhitePasses ? PassNoise::kWhite : PassNoise::kColoured;
}

std::vector<ChannelNoise> NoiseInPass(PassNoise kind,
                                      const std::vector<WindowResiduals>& residuals,
                                      const std::vector<FittedChannel>& channels,
                                      const std::vector<double>& quietest,
                                      const std::vector<ChannelNoise>& given) {
  switch (kind) {
    case PassNoise::kGiven:
      return given;
    case PassNoise::kWhite:
      return WhiteNoiseOf(residuals, channels, quietest);
    case PassNoise::kColoured:
      break;
  }
  return ColouredNoiseOf(residuals, channels, quietest);
}

// From where another search under coloured noise has ended, the next has not far to go.
WindowSearchOptions SearchInPass(int pass, bool is_given, const CoupledFitOptions& options) {
  if (KindOfNoise(pass, is_given) == PassNoise::kWhite) return RoughSearch(options);
  WindowSearchOptions with;
  with.max_iterations = options.max_iterations;
  with.precision = options.learns_noise ? kFinePrecision : kRoughPrecision;
  if (is_given || pass > kWhitePasses) with.first_damping = kDampingNearTheEnd;
  return with;
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

// The last pass under white noise; without weights before there was one.
struct WhitePass {
  std::vector<ChannelWeight> weights;
  double cost = std::numeric_limits<double>::infinity();
};

bool IsAstray(const WhitePass& white, const std::vector<WindowResiduals>& residuals) {
  return !white.weights.empty() && CostUnder(white.weights, residuals) > kAstray * white.cost;
}

// How far the entries moved, in standard deviations by the `normal` equations.
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

// Whether a pass that moved the entries by `move` [standard deviations] is the last.
bool IsLast(PassNoise kind, double move, bool learns_noise) {
  if (kind == PassNoise::kGiven && !learns_noise) return true;
  return kind != PassNoise::kWhite && move < kSettled;
}

// What remains after a pass that failed.
WindowSearch BestAfterFailure(WindowSearch best, WindowSearch failed) {
  if (best.converged) return best;
  failed.converged = false;
  return failed;
}

}  // namespace

WindowSearchOptions RoughSearch(const CoupledFitOptions& options) {
  WindowSearchOptions with;
  with.max_iterations = options.max_iterations;
  with.precision = kRoughPrecision;
  with.smallest_gain = kRoughGain;
  return with;
}

FitPasses FitInPasses(const WindowProblem& problem,
                      const WindowPoint& start,
                      const std::vector<WindowResiduals>& residuals,
                      const CoupledFitOptions& options) {
  const std::vector<double> quietest = QuietestSensors(problem);
  const bool is_given = IsOf(options.noise, problem.channels);
  std::vector<WindowResiduals> left = residuals;
  WindowPoint from = start;
  WhitePass white;
  FitPasses passes;
  for (int pass = 0; pass < kMostPasses; ++pass) {
    const PassNoise kind = KindOfNoise(pass, is_given);
    std::vector<ChannelNoise> noise =
        NoiseInPass(kind, left, problem.channels, quietest, options.noise);
    const std::vector<ChannelWeight> weights = WeightsOf(noise, options.huber_k);
    WindowSearch search =
        SearchWindows(problem, weights, from, SearchInPass(pass, is_given, options));
    passes.num_iterations += search.num_iterations;
    if (!search.converged || !AllResiduals(problem, search.point, &left)) {
      passes.best = BestAfterFailure(std::move(passes.best), std::move(search));
      break;
    }
    if (kind == PassNoise::kWhite) {
      white = {weights, search.cost};
    } else if (IsAstray(white, left)) {
      break;
    }
    const double move =
        LargestMove(from.model, search.point.model, problem.entries, search.near.normal);
    from = search.point;
    passes.noise = std::move(noise);
    passes.best = std::move(search);
    if (IsLast(kind, move, options.learns_noise)) break;
  }
  return passes;
}

}  // namespace fathom
