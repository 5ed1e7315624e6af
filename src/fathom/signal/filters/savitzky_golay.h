// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fathom {

struct SavitzkyGolayOptions {
  double window = 1.0;  // length of the whole window [s], above 0
  int order = 3;        // of the polynomial, 0 to 9
};

// Local polynomial least squares on irregular stamps: a polynomial is fitted to the samples in a
// window about each stamp and evaluated, with its derivatives, at the stamp; docs/signal.md (1).
//
//   window   [t_i - w/2, t_i + w/2], shifted inwards where it would reach beyond the data
//   weights  estimate of derivative d at t_i = sum_j weight_j value_{first + j}
//
// A silence of more than half the window counts as an end of the data: it is never bridged. On
// equal steps with w = (2k + 1/2) steps these are the weights of a filter of 2k + 1 points.
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

  // The window at the stamp last moved to: samples first() to first() + size() - 1.
  size_t first() const { return first_; }
  size_t size() const { return size_; }

  // False if the window is shifted: the stamp is closer than half a window to an end of the data.
  // A derivative there has several times the noise.
  bool is_centred() const { return is_centred_; }

  // Weights of derivative `derivative` (0 to order) at the stamp last moved to; overwritten by the
  // next call.
  std::span<const double> Weights(int derivative);

  // sum_j weights[j] values[first() + j].
  double Apply(std::span<const double> weights, std::span<const double> values) const;

 private:
  void FindPiece(size_t i);
  bool PlaceSamples(double t);
  bool Factorize();

  std::span<const double> time_;
  SavitzkyGolayOptions options_;
  size_t piece_begin_ = 0, piece_end_ = 0;  // between two silences
  size_t first_ = 0, size_ = 0;
  bool is_centred_ = false;
  std::vector<double> place_;   // of the samples: (t_j - t_i) / (w/2)
  bool is_factorized_ = false;  // for the samples at place_
  std::vector<double> Q_;       // one column of size_ after the other
  std::vector<double> R_;       // upper triangle, row-major
  int derivative_ = -1;         // that weights_ are of, for the samples at place_; -1: of none
  std::vector<double> weights_;
};

// Derivative `derivative` of `values` at every stamp, NaN where the fit fails.
std::vector<double> SavitzkyGolay(std::span<const double> time,
                                  std::span<const double> values,
                                  int derivative,
                                  const SavitzkyGolayOptions& options);

// How noisy values at these stamps are best smoothed: the shortest window [s] whose prediction of
// left-out samples is within 1 % of the best, by mean absolute error, among windows from
// `shortest` upwards in steps of sqrt(2) to `longest`. A sample is left out together with its
// neighbours within a quarter of the shortest window, lest noise that they share looks like
// motion; docs/signal.md (4).
double ChooseWindow(std::span<const double> time,
                    std::span<const double> values,
                    int order,
                    double shortest,
                    double longest);

}  // namespace fathom
