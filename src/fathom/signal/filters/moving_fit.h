// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/signal/filters/local_polynomial.h"
#include "fathom/signal/filters/moving_window.h"
#include "fathom/signal/filters/normal_equations.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace fathom {

// LocalPolynomial for columns of which only the estimates are asked for, not the weights: a window
// that moves along the stamps takes in one sample and gives up another, so a stamp costs the same
// however long the window is.
//
//   sum_j T_k(x_j), k = 0 to 2p,   and   sum_j T_k(x_j) y_j, k = 0 to p
//   x_j = (t_j - origin) / reach
//
// are the normal equations of docs/signal.md (1) in Chebyshev's polynomials, since
// 2 T_a T_b = T_{a+b} + T_{|a-b|}. Where they are badly conditioned, as for high orders, few
// samples or samples close together, LocalPolynomial stands in.
//
//   MovingFit fit(time, {position, impulse}, {.window = 1.0, .order = 3});
//   for (size_t i = 0; i < time.size(); ++i) {
//     if (fit.MoveTo(i, 1)) velocity[i] = fit.Estimate(0), force[i] = fit.Estimate(1);
//   }
class MovingFit {
 public:
  // Each column has a finite value for each stamp. Keeps views of `time` and `columns`.
  MovingFit(std::span<const double> time,
            std::vector<std::span<const double>> columns,
            const SavitzkyGolayOptions& options);

  // Fits at stamp `i` for derivative `derivative`, 0 to order; false if that fails. Quickest in
  // rising order of `i`.
  bool MoveTo(std::size_t i, int derivative);

  // The derivative of a column at the stamp last moved to.
  double Estimate(std::size_t column) const;

  const MovingWindow& window() const { return window_; }

 private:
  using Coefficients = NormalEquations::Coefficients;

  void Renew();
  void Count(std::size_t sample, double sign);
  template <int kOrder>
  void CountUpTo(std::size_t sample, double sign);

  std::span<const double> time_;
  std::vector<std::span<const double>> columns_;
  int order_;
  double stray_;  // of the window's middle from the origin, at most [s]
  double reach_;  // of the samples from it [s]
  MovingWindow window_;
  LocalPolynomial stand_in_;

  // Sums over the samples first_ to past_last_ - 1, about origin_ [s] and values near them.
  double origin_ = 0.0;
  std::size_t first_ = 0, past_last_ = 0;
  std::array<double, 2 * kHighestOrder + 1> sums_ = {};
  std::vector<Coefficients> column_sums_;
  std::vector<double> references_;

  // Of the stamp last moved to.
  NormalEquations equations_;
  Coefficients solution_ = {};  // the estimate is its product with a column's sums,
  bool adds_reference_ = false;
  std::span<const double> weights_;  // or, where these stand in, that of them with the samples
};

}  // namespace fathom
