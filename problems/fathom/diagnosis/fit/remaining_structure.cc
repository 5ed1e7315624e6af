// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/fit/remaining_structure.h"

#include "fathom/base/parallel_for.h"
#include "fathom/diagnosis/fit/force_response.h"
#include "fathom/noise/fit_noise.h"
#include "fathom/noise/whitener.h"
#include "fathom/solve/decompositions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <unsupported/Eigen/SpecialFunctions>

namespace fathom {
namespace {

using Points = std::vector<RunPoint>;

// Triangles over the range of x, each 1 at its own quantile and 0 at its neighbours'.
void AppendHats(const std::vector<double>& x, int count, std::vector<std::vector<double>>* forces) {
  std::vector<double> sorted = x;
  std::sort(sorted.begin(), sorted.end());
  std::vector<double> knots;
  for (int k = 0; k < count; ++k) {
    const double knot = sorted[(sorted.size() - 1) * k / (count - 1)];
    if (knots.empty() || knot > knots.back() + 1e-9 * (sorted.back() - sorted.front())) {
      knots.push_back(knot);
    }
  }
  for (size_t k = 0; k < knots.size(); ++k) {
    std::vector<double> force;
    for (const double value : x) {
      double height = 1.0;
      if (value < knots[k] && k > 0) {
        height = std::max(0.0, (value - knots[k - 1]) / (knots[k] - knots[k - 1]));
      } else if (value > knots[k] && k + 1 < knots.size()) {
        height = std::max(0.0, (knots[k + 1] - value) / (knots[k + 1] - knots[k]));
      }
      force.push_back(height);
    }
    forces->push_back(std::move(force));
  }
}

// A signal along the run, through a first-order lag.
std::vector<double> Lagged(const Points& points,
                           const std::vector<double>& signal,
                           double time_constant) {
  std::vector<double> lagged;
  for (size_t i = 0; i < points.size(); ++i) {
    const bool starts = i == 0 || points[i].segment != points[i - 1].segment;
    const double kept =
        starts ? 0.0 : std::exp(-(points[i].time - points[i - 1].time) / time_constant);
    const double before = starts ? 0.0 : lagged.back();
    lagged.push_back(kept * before + (1.0 - kept) * signal[i]);
  }
  return lagged;
}

std::vector<std::vector<double>> FreeForces(const Points& points) {
  const auto column = [&](const auto& function) {
    std::vector<double> values;
    values.reserve(points.size());
    for (const auto& point : points) values.push_back(function(point));
    return values;
  };
  const auto command = column([](const auto& p) { return p.command; });
  const auto speed = column([](const auto& p) { return p.velocity; });
  std::vector<std::vector<double>> forces;
  AppendHats(command, 7, &forces);
  AppendHats(speed, 7, &forces);
  AppendHats(column([](const auto& p) { return p.position; }), 5, &forces);
  for (const double time_constant : {0.3, 1.0, 3.0, 10.0}) {
    forces.push_back(Lagged(points, command, time_constant));
  }
  forces.push_back(column([](const auto& p) { return p.command * p.velocity; }));
  forces.push_back(column([](const auto& p) { return std::abs(p.command) * p.velocity; }));
  forces.push_back(column([](const auto& p) { return p.command * std::abs(p.velocity); }));
  return forces;
}

// Thrust that changes as the run goes on.
std::vector<std::vector<double>> ThrustOverTime(const Points& points) {
  std::vector<double> order(points.size());
  std::iota(order.begin(), order.end(), 0.0);
  std::vector<std::vector<double>> forces;
  AppendHats(order, 6, &forces);
  for (std::vector<double>& force : forces) {
    for (size_t i = 0; i < force.size(); ++i) force[i] *= points[i].command;
  }
  return forces;
}

// Free forms of one input each.
std::vector<std::pair<std::string_view, std::vector<std::vector<double>>>> FormsByInput(
    const Points& points) {
  std::vector<double> command, effort, speed, place;
  for (const RunPoint& point : points) {
    command.push_back(point.command);
    effort.push_back(std::abs(point.command));
    speed.push_back(point.velocity);
    place.push_back(point.position);
  }
  std::vector<std::pair<std::string_view, std::vector<std::vector<double>>>> forms;
  const auto append_hats = [&](std::string_view input, const auto& values, int count) {
    AppendHats(values, count, &forms.emplace_back(input, 0).second);
  };
  append_hats("command", command, 7);
  append_hats("velocity", speed, 7);
  append_hats("displacement", place, 5);
  append_hats("displacement", place, 9);
  auto& past = forms.emplace_back("past command", 0).second;
  for (const double time_constant : {0.3, 1.0, 3.0, 10.0}) {
    past.push_back(Lagged(points, command, time_constant));
  }
  auto& warmth = forms.emplace_back("effort of the thrusters so far", 0).second;
  for (const double time_constant : {10.0, 60.0}) {
    warmth.push_back(Lagged(points, effort, time_constant));
    for (size_t i = 0; i < points.size(); ++i) warmth.back()[i] *= command[i];
  }
  return forms;
}

// Residual after generalised least squares on `columns` under `whitener`.
Eigen::VectorXd ResidualAfter(const RowMajorMatrix& columns,
                              const Eigen::VectorXd& residual,
                              const Whitener& whitener) {
  RowMajorMatrix block(columns.rows(), columns.cols() + 1);
  block.leftCols(columns.cols()) = columns;
  block.rightCols(1) = residual;
  whitener.Apply(block, block);
  const Eigen::MatrixXd J = block.leftCols(columns.cols());
  return residual - columns * LeastSquares(J, block.rightCols(1));
}

// What forces of one kind would gain.
RemainingStructure RemainingOf(const std::vector<std::vector<double>>& forces,
                               const ForceResponse& response,
                               const TrainingData& data,
                               const StructureFit& fit) {
  RemainingStructure remaining;
  const Eigen::Index num_fitted = fit.jacobian.cols();
  RowMajorMatrix design(data.bins().size(), num_fitted + static_cast<Eigen::Index>(forces.size()));
  design.leftCols(num_fitted) = fit.jacobian;
  for (size_t k = 0; k < forces.size(); ++k) {
    design.col(num_fitted + static_cast<Eigen::Index>(k)) = response.Outputs(forces[k]);
  }
  for (auto column : design.colwise()) column /= std::max(column.norm(), 1e-300);
  constexpr double kLeastPivot = 1e-5;
  const Eigen::Index rank = RankOf(design, kLeastPivot);
  const Eigen::Index own_rank = RankOf(design.leftCols(num_fitted), kLeastPivot);
  constexpr Eigen::Index kSamplesPerColumn = 5;
  if (rank <= own_rank || design.rows() < kSamplesPerColumn * rank) return remaining;

  Whitener whitener(fit.noise, data.samples());
  Eigen::VectorXd residual = ResidualAfter(design, fit.residual, whitener);
  FitNoiseOptions options;
  options.damping_rate = data.DampingRate(fit.model.baseline);
  const NoiseFit noise =
      FitNoise(data.samples(), std::span(residual.data(), residual.size()), design, options);
  if (!std::isfinite(noise.log_likelihood)) return remaining;
  whitener = Whitener(noise.model, data.samples());
  residual = ResidualAfter(design, fit.residual, whitener);
  const double log_likelihood = whitener.LogLikelihood(std::span(residual.data(), residual.size()));
  remaining.num_columns = static_cast<int>(rank - own_rank);
  remaining.gain = std::max(0.0, 2.0 * (log_likelihood - fit.log_likelihood));
  remaining.p_value = Eigen::numext::igammac(0.5 * remaining.num_columns, 0.5 * remaining.gain);
  return remaining;
}

}  // namespace

RemainingStructure FindRemainingStructure(const TrainingData& data, const StructureFit& fit) {
  const ForceResponse response(&data, fit);
  if (response.is_empty()) return {};
  const Points& points = response.points();
  constexpr int kLooks = 2;
  std::array<RemainingStructure, kLooks> looks;
  ParallelFor(kLooks, [&](int k) {
    looks[k] =
        RemainingOf(k == 0 ? FreeForces(points) : ThrustOverTime(points), response, data, fit);
  });
  auto& [remaining, over_time] = looks;
  if (remaining.num_columns == 0) return remaining;
  if (over_time.p_value < std::min(remaining.p_value, RemainingStructure::kClear / kLooks)) {
    remaining = over_time;
  }
  remaining.p_value = std::min(1.0, kLooks * remaining.p_value);
  return remaining;
}

FreeForm BestFreeForm(const TrainingData& data, const StructureFit& fit) {
  const ForceResponse response(&data, fit);
  if (response.is_empty()) return {};
  const auto forms = FormsByInput(response.points());
  std::vector<RemainingStructure> found(forms.size());
  ParallelFor(static_cast<int>(forms.size()),
              [&](int k) { found[k] = RemainingOf(forms[k].second, response, data, fit); });
  FreeForm best;
  for (std::size_t k = 0; k < forms.size(); ++k) {
    if (found[k].num_columns == 0) continue;
    const double gain = found[k].gain - found[k].num_columns;
    if (best.input.empty() || gain > best.gain) best = {forms[k].first, gain};
  }
  return best;
}

}  // namespace fathom
