// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/fit/remaining_structure.h"

#include "fathom/base/chi_square.h"
#include "fathom/base/parallel_for.h"
#include "fathom/diagnosis/fit/force_response.h"
#include "fathom/noise/fit_noise.h"
#include "fathom/noise/whitener.h"
#include "fathom/solve/decompositions.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Core>

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

std::vector<double> ColumnOf(const Points& points, double (*function)(const RunPoint&)) {
  std::vector<double> values;
  values.reserve(points.size());
  for (const RunPoint& point : points) values.push_back(function(point));
  return values;
}

std::vector<std::vector<double>> ProductsOfCommandAndSpeed(const Points& points) {
  return {ColumnOf(points, [](const RunPoint& p) { return p.command * p.velocity; }),
          ColumnOf(points, [](const RunPoint& p) { return std::abs(p.command) * p.velocity; }),
          ColumnOf(points, [](const RunPoint& p) { return p.command * std::abs(p.velocity); })};
}

std::vector<std::vector<double>> FreeForces(const Points& points) {
  const auto command = ColumnOf(points, [](const RunPoint& p) { return p.command; });
  const auto speed = ColumnOf(points, [](const RunPoint& p) { return p.velocity; });
  std::vector<std::vector<double>> forces;
  AppendHats(command, 7, &forces);
  AppendHats(speed, 7, &forces);
  AppendHats(ColumnOf(points, [](const RunPoint& p) { return p.position; }), 5, &forces);
  for (const double time_constant : {0.3, 1.0, 3.0, 10.0}) {
    forces.push_back(Lagged(points, command, time_constant));
  }
  for (std::vector<double>& product : ProductsOfCommandAndSpeed(points)) {
    forces.push_back(std::move(product));
  }
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
  forms.emplace_back("command and speed", ProductsOfCommandAndSpeed(points));
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

// The columns of forces of one kind beside those of the fit, each of length 1.
RowMajorMatrix DesignOf(const std::vector<std::vector<double>>& forces,
                        const ForceResponse& response,
                        const StructureFit& fit) {
  const Eigen::Index num_fitted = fit.jacobian.cols();
  RowMajorMatrix design(fit.jacobian.rows(), num_fitted + static_cast<Eigen::Index>(forces.size()));
  design.leftCols(num_fitted) = fit.jacobian;
  for (size_t k = 0; k < forces.size(); ++k) {
    design.col(num_fitted + static_cast<Eigen::Index>(k)) = response.Outputs(forces[k]);
  }
  for (auto column : design.colwise()) column /= std::max(column.norm(), 1e-300);
  return design;
}

// Of the residual beside these columns, the noise learned along; minus infinity where it cannot be.
double LogLikelihoodBeside(const RowMajorMatrix& design,
                           const TrainingData& data,
                           const StructureFit& fit) {
  Whitener whitener(fit.noise, data.samples());
  Eigen::VectorXd residual = ResidualAfter(design, fit.residual, whitener);
  FitNoiseOptions options;
  options.damping_rate = data.DampingRate(fit.model.baseline);
  const NoiseFit noise =
      FitNoise(data.samples(), std::span(residual.data(), residual.size()), design, options);
  if (!std::isfinite(noise.log_likelihood)) return -INFINITY;
  whitener = Whitener(noise.model, data.samples());
  residual = ResidualAfter(design, fit.residual, whitener);
  return whitener.LogLikelihood(std::span(residual.data(), residual.size()));
}

// Over what a gain counts: the fit as it is, or with its noise learned anew, which may find
// another, likelier maximum. Anew only where the fit weighs by learned noise: what a free run
// misses is none.
enum class Over { kFit, kFitWithNoiseAnew };

// What each kind of forces would gain. The noise is learned beside each of them: that of the fit
// has swallowed what it leaves, so that no look under that noise would do.
std::vector<RemainingStructure> RemainingOf(
    const std::vector<std::vector<std::vector<double>>>& kinds,
    const ForceResponse& response,
    const TrainingData& data,
    const StructureFit& fit,
    Over over) {
  constexpr double kLeastPivot = 1e-5;
  constexpr Eigen::Index kSamplesPerColumn = 5;
  const RowMajorMatrix own = DesignOf({}, response, fit);
  const Eigen::Index own_rank = RankOf(own, kLeastPivot);
  std::vector<RemainingStructure> remaining(kinds.size());
  std::vector<double> log_likelihoods(kinds.size(), -INFINITY);
  ParallelFor(static_cast<int>(kinds.size()), [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    const RowMajorMatrix design = DesignOf(kinds[k], response, fit);
    const Eigen::Index rank = RankOf(design, kLeastPivot);
    if (rank <= own_rank || design.rows() < kSamplesPerColumn * rank) return;
    log_likelihoods[k] = LogLikelihoodBeside(design, data, fit);
    if (std::isfinite(log_likelihoods[k])) {
      remaining[k].num_columns = static_cast<int>(rank - own_rank);
    }
  });
  const auto count_from = [&](double without) {
    double least = 1.0;
    for (std::size_t k = 0; k < kinds.size(); ++k) {
      RemainingStructure& of_kind = remaining[k];
      if (of_kind.num_columns == 0) continue;
      of_kind.gain = std::max(0.0, 2.0 * (log_likelihoods[k] - without));
      of_kind.p_value = ChiSquareTail(of_kind.gain, of_kind.num_columns);
      least = std::min(least, of_kind.p_value);
    }
    return least;
  };
  constexpr double kLooksClear = 0.01;
  if (count_from(fit.log_likelihood) < kLooksClear && over == Over::kFitWithNoiseAnew) {
    count_from(std::max(fit.log_likelihood, LogLikelihoodBeside(own, data, fit)));
  }
  return remaining;
}

// What forms of each input would gain, of those that can be tried.
std::vector<std::pair<std::string_view, RemainingStructure>> TriedByInput(const TrainingData& data,
                                                                          const StructureFit& fit) {
  const ForceResponse response(&data, fit);
  if (response.is_empty()) return {};
  std::vector<std::pair<std::string_view, RemainingStructure>> tried;
  std::vector<std::vector<std::vector<double>>> kinds;
  for (auto& [input, forces] : FormsByInput(response.points())) {
    tried.emplace_back(input, RemainingStructure());
    kinds.push_back(std::move(forces));
  }
  const std::vector<RemainingStructure> remaining =
      RemainingOf(kinds, response, data, fit, Over::kFitWithNoiseAnew);
  for (std::size_t k = 0; k < tried.size(); ++k) tried[k].second = remaining[k];
  std::erase_if(tried, [](const auto& form) { return form.second.num_columns == 0; });
  return tried;
}

}  // namespace

RemainingStructure FindRemainingStructure(const TrainingData& data, const StructureFit& fit) {
  const ForceResponse response(&data, fit);
  if (response.is_empty()) return {};
  const Points& points = response.points();
  constexpr int kLooks = 2;
  const std::vector<RemainingStructure> looks =
      RemainingOf({FreeForces(points), ThrustOverTime(points)}, response, data, fit, Over::kFit);
  RemainingStructure remaining = looks.front();
  if (remaining.num_columns == 0) return remaining;
  if (looks.back().p_value < std::min(remaining.p_value, RemainingStructure::kClear / kLooks)) {
    remaining = looks.back();
  }
  remaining.p_value = std::min(1.0, kLooks * remaining.p_value);
  return remaining;
}

RemainingStructure FindRemainingOfOneInput(const TrainingData& data, const StructureFit& fit) {
  RemainingStructure clearest;
  const auto tried = TriedByInput(data, fit);
  for (const auto& [input, remaining] : tried) {
    if (remaining.p_value < clearest.p_value) clearest = remaining;
  }
  clearest.p_value = std::min(1.0, static_cast<double>(tried.size()) * clearest.p_value);
  return clearest;
}

FreeForm BestFreeForm(const TrainingData& data, const StructureFit& fit) {
  FreeForm best;
  for (const auto& [input, remaining] : TriedByInput(data, fit)) {
    const double gain = remaining.gain - remaining.num_columns;
    if (best.input.empty() || gain > best.gain) best = {input, gain};
  }
  return best;
}

}  // namespace fathom
