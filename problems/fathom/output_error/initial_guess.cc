// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/initial_guess.h"

#include "fathom/adaptive/fit_adaptive.h"
#include "fathom/least_squares/least_squares.h"
#include "fathom/simulate/free_run.h"

#include <algorithm>
#include <cmath>

namespace fathom {
namespace {

constexpr double kPoorNmae = 0.5;

UncoupledModel<double> MadePhysical(UncoupledModel<double> model) {
  model.quadratic_damping = std::max(model.quadratic_damping, 0.0);
  model.linear_damping = std::max(model.linear_damping, 0.0);
  return model;
}

double RootMeanSquare(std::span<const Segment> segments, std::vector<double> Segment::*column) {
  double sum = 0.0;
  int count = 0;
  for (const Segment& segment : segments) {
    for (const double value : segment.*column) {
      if (!std::isfinite(value)) continue;
      sum += value * value;
      ++count;
    }
  }
  return count > 0 ? std::sqrt(sum / count) : 0.0;
}

// Half of the force accelerates, half overcomes a linear damping.
UncoupledModel<double> RoughGuess(std::span<const Segment> segments) {
  const double force = RootMeanSquare(segments, &Segment::smoothed_force);
  const double acceleration = RootMeanSquare(segments, &Segment::acceleration);
  const double velocity = RootMeanSquare(segments, &Segment::velocity);
  UncoupledModel<double> model;
  if (force > 0.0 && acceleration > 0.0) model.inertia = 0.5 * force / acceleration;
  if (force > 0.0 && velocity > 0.0) model.linear_damping = 0.5 * force / velocity;
  return model;
}

}  // namespace

InitialGuess ChooseInitialGuess(std::span<const Segment> segments) {
  InitialGuess best = {RoughGuess(segments), "rough"};
  double best_nmae = FiguresOf({best.model}, segments).nmae;
  const auto consider = [&](const UncoupledModel<double>& model, const std::string& family) {
    const UncoupledModel<double> physical = MadePhysical(model);
    const double nmae = FiguresOf({physical}, segments).nmae;
    if (!std::isfinite(nmae) || nmae >= best_nmae) return;
    best = {physical, family};
    best_nmae = nmae;
  };
  const LeastSquaresSummary least_squares = FitLeastSquares(segments);
  if (least_squares.IsUsable()) consider(least_squares.model, "least_squares");
  if (best.family == "least_squares" && best_nmae < kPoorNmae) return best;
  const AdaptiveSummary adaptive = FitAdaptive(segments);
  if (adaptive.IsUsable()) consider(adaptive.model, "adaptive");
  return best;
}

}  // namespace fathom
