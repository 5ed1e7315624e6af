// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/signal/filters/moving_window.h"

#include <cstddef>
#include <span>
#include <vector>

namespace fathom {

inline constexpr int kHighestOrder = 9;

struct SavitzkyGolayOptions {
  double window = 1.0;  // length of the whole window [s], above 0
  int order = 3;        // of the polynomial, 0 to kHighestOrder
};

// Local polynomial least squares on irregular stamps: a polynomial is fitted to the samples in a
// window about each stamp (MovingWindow) and evaluated, with its derivatives, at the stamp;
// docs/signal.md (1).
//
//   estimate of derivative d at t_i = sum_j weight_j value_{first + j}
//
// On equal steps with w = (2k + 1/2) steps these are the weights of a filter of 2k + 1 points.
//
// Fails at a stamp whose window holds fewer than order + 1 samples, or samples so close together
// that they say nothing about the window's length.
//
//   LocalPolynomial fit(time, {.window = 1.0, .order = 3});
//   for (size_t i = 0; i < time.size(); ++i) {
//     slope[i] = fit.MoveTo(i) ? fit.Apply(fit.Weights(1), values) : NaN;
//   }
//
// Allocates when made and as the widest window grows, not per sample. Keeps a view of `time`.
class LocalPolynomial {
 public:
  LocalPolynomial(std::span<const double> time, const SavitzkyGolayOptions& options);

  // Fits at stamp `i`; false if that fails. Quickest in rising order of `i`.
  bool MoveTo(size_t i);

  const MovingWindow& window() const { return window_; }

  // Weights of derivative `derivative` (0 to order) at the stamp last moved to; overwritten by the
  // next call.
  std::span<const double> Weights(int derivative);

  // sum_j weights[j] values[first + j].
  double Apply(std::span<const double> weights, std::span<const double> values) const;

 private:
  bool PlaceSamples(double t);
  bool Factorize();

  std::span<const double> time_;
  SavitzkyGolayOptions options_;
  MovingWindow window_;
  std::vector<double> place_;   // of the samples: (t_j - t_i) / (w/2)
  bool is_factorized_ = false;  // for the samples at place_
  std::vector<double> Q_;       // one column of the window's size after the other
  std::vector<double> R_;       // upper triangle, row-major
  int derivative_ = -1;         // that weights_ are of, for the samples at place_; -1: of none
  std::vector<double> weights_;
};

}  // namespace fathom
