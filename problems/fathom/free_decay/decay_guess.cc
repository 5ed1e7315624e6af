// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/free_decay/decay_guess.h"

#include "fathom/free_decay/decay_search.h"
#include "fathom/solve/decompositions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fathom {
namespace {

// The integral from the first stamp on, by trapezoids.
Eigen::VectorXd IntegralOf(const Eigen::VectorXd& value, const std::vector<double>& time) {
  Eigen::VectorXd integral = Eigen::VectorXd::Zero(value.size());
  for (Eigen::Index i = 1; i < value.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    integral[i] = integral[i - 1] + (time[k] - time[k - 1]) * (value[i] + value[i - 1]) / 2.0;
  }
  return integral;
}

Eigen::VectorXd SecondsOf(const std::vector<double>& time) {
  Eigen::VectorXd t(static_cast<Eigen::Index>(time.size()));
  for (Eigen::Index i = 0; i < t.size(); ++i) {
    t[i] = time[static_cast<std::size_t>(i)] - time.front();
  }
  return t;
}

}  // namespace

Eigen::VectorXd DecayGuess(std::span<const DecayStretch> stretches,
                           const FreeDecayOptions& options) {
  const bool is_velocity = options.output == DecayOutput::kVelocity;
  Eigen::Index n = 0;
  for (const DecayStretch& stretch : stretches) n += static_cast<Eigen::Index>(stretch.time.size());
  // Columns: a, b, c, then for each stretch 1, t and of displacements t^2.
  const auto num_stretches = static_cast<Eigen::Index>(stretches.size());
  const Eigen::Index per_stretch = is_velocity ? 2 : 3;
  Eigen::MatrixXd F = Eigen::MatrixXd::Zero(n, 3 + per_stretch * num_stretches);
  Eigen::VectorXd y(n);
  Eigen::Index row = 0;
  for (Eigen::Index s = 0; s < num_stretches; ++s) {
    const DecayStretch& stretch = stretches[static_cast<std::size_t>(s)];
    const Eigen::VectorXd t = SecondsOf(stretch.time);
    const auto m = static_cast<Eigen::Index>(stretch.time.size());
    const Eigen::VectorXd motion = Eigen::Map<const Eigen::VectorXd>(stretch.motion.data(), m);
    const auto rows = Eigen::seqN(row, m);
    const Eigen::Index first = 3 + per_stretch * s;
    const Eigen::VectorXd integral = IntegralOf(motion, stretch.time);
    y(rows) = motion;
    F(rows, 0) = -integral;
    if (is_velocity) F(rows, 1) = -IntegralOf(motion.cwiseProduct(motion.cwiseAbs()), stretch.time);
    if (options.has_stiffness) F(rows, 2) = -IntegralOf(integral, stretch.time);
    F(rows, first).setOnes();
    F(rows, first + 1) = t;
    if (!is_velocity) F(rows, first + 2) = t.cwiseProduct(t) / 2.0;
    row += m;
  }
  // Of displacements c stands at the double integral, too: its column is the same.
  const Eigen::VectorXd solved = LeastSquares(F, y);

  const DecayUnknowns unknowns(stretches.size(), options);
  Eigen::VectorXd guess = Eigen::VectorXd::Zero(unknowns.size());
  for (int rate = 0; rate < 3; ++rate) {
    guess[rate] = std::isfinite(solved[rate]) ? std::max(solved[rate], 0.0) : 0.0;
  }
  const double c = guess[kStiffnessRate];
  for (std::size_t s = 0; s < stretches.size(); ++s) {
    const Eigen::Index first = 3 + per_stretch * static_cast<Eigen::Index>(s);
    const auto at = unknowns.FirstOf(s);
    const double one = solved[first], slope = solved[first + 1];
    if (is_velocity) {
      guess[at] = one;
      // The slope is -c x_0, or -d.
      if (options.has_stiffness && c > 0.0) guess[at + 1] = -slope / c;
    } else {
      // y = y_0 + (v_0 + a y_0) t - a int y - c int int (y - rest) and so on.
      const double a = guess[kLinearRate];
      guess[at] = slope - a * one;
      const double rest = options.has_stiffness && c > 0.0 ? solved[first + 2] / c : 0.0;
      guess[at + 1] = one - rest;
      guess[at + 2] = rest;
    }
  }
  return guess;
}

}  // namespace fathom
