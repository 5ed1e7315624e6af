// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/filters/savitzky_golay.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Core>
#include <glog/logging.h>

namespace fathom {
namespace {

constexpr int kHighestOrder = 9;

// Stamps count as inside a window that they miss by rounding: the share of the window that a stamp
// may lie outside.
constexpr double kRounding = 1e-6;

// Samples that stand this near to where the last window's stood, as a share of half the window,
// have its weights: equal steps, but for the rounding of stamps of up to a day.
constexpr double kSamePlace = 1e-9;

// A column of the monomials adds nothing if what the lower ones leave of it is below this share of
// what it would be at the window's edge.
constexpr double kIllPlaced = 1e-7;

constexpr size_t kMostScored = 500;  // stamps that ChooseWindow predicts
constexpr double kTolerance = 1.01;  // of the best score
constexpr double kLeftOut = 0.26;    // of the shortest window, on either side of a sample
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// One per power of the polynomial.
using Coefficients = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kHighestOrder + 1, 1>;

bool IsNear(std::span<const double> a, std::span<const double> b, double tolerance) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [tolerance](double x, double y) {
    return std::abs(x - y) <= tolerance;
  });
}

size_t LowerBound(std::span<const double> time, double t) {
  return std::lower_bound(time.begin(), time.end(), t) - time.begin();
}

}  // namespace

LocalPolynomial::LocalPolynomial(std::span<const double> time, const SavitzkyGolayOptions& options)
    : time_(time), options_(options) {
  CHECK_GT(options.window, 0.0);
  CHECK_GE(options.order, 0);
  CHECK_LE(options.order, kHighestOrder);
  R_.resize(static_cast<size_t>(options.order + 1) * (options.order + 1));
}

void LocalPolynomial::FindPiece(size_t i) {
  if (piece_begin_ <= i && i < piece_end_) return;
  const double longest = 0.5 * options_.window * (1.0 + kRounding);
  for (piece_begin_ = i; piece_begin_ > 0; --piece_begin_) {
    if (time_[piece_begin_] - time_[piece_begin_ - 1] > longest) break;
  }
  for (piece_end_ = i + 1; piece_end_ < time_.size(); ++piece_end_) {
    if (time_[piece_end_] - time_[piece_end_ - 1] > longest) break;
  }
  first_ = piece_begin_;
  size_ = 0;
}

bool LocalPolynomial::MoveTo(size_t i) {
  CHECK_LT(i, time_.size());
  FindPiece(i);
  const double t = time_[i];
  const double slack = kRounding * options_.window;
  const double begin = time_[piece_begin_], end = time_[piece_end_ - 1];
  double from = t - 0.5 * options_.window, to = t + 0.5 * options_.window;
  is_centred_ = from >= begin - slack && to <= end + slack;
  if (from < begin) {
    from = begin;
    to = std::min(begin + options_.window, end);
  } else if (to > end) {
    from = std::max(end - options_.window, begin);
    to = end;
  }
  size_t past_last = first_ + size_;
  while (first_ > piece_begin_ && time_[first_ - 1] >= from - slack) --first_;
  while (time_[first_] < from - slack) ++first_;
  past_last = std::max(past_last, first_);
  while (past_last < piece_end_ && time_[past_last] <= to + slack) ++past_last;
  while (past_last > first_ && time_[past_last - 1] > to + slack) --past_last;
  size_ = past_last - first_;
  if (PlaceSamples(t)) {
    derivative_ = -1;
    is_factorized_ = Factorize();
  }
  return is_factorized_;
}

// False if the samples stand where they stood in the last window.
bool LocalPolynomial::PlaceSamples(double t) {
  const double scale = 2.0 / options_.window;
  bool is_new = place_.size() != size_;
  for (size_t j = 0; j < size_ && !is_new; ++j) {
    is_new = std::abs((time_[first_ + j] - t) * scale - place_[j]) > kSamePlace;
  }
  if (!is_new) return false;
  place_.resize(size_);
  for (size_t j = 0; j < size_; ++j) place_[j] = (time_[first_ + j] - t) * scale;
  return true;
}

// Gram-Schmidt, each column twice, of the monomials in place_.
bool LocalPolynomial::Factorize() {
  const int n = options_.order + 1;
  const size_t m = size_;
  if (m < static_cast<size_t>(n)) return false;
  if (Q_.size() < m * n) Q_.resize(m * n);
  if (weights_.size() < m) weights_.resize(m);
  for (size_t j = 0; j < m; ++j) {
    double power = 1.0;
    for (int k = 0; k < n; ++k, power *= place_[j]) Q_[k * m + j] = power;
  }
  std::fill(R_.begin(), R_.end(), 0.0);
  Eigen::Map<Eigen::MatrixXd> Q(Q_.data(), static_cast<Eigen::Index>(m), n);
  for (int k = 0; k < n; ++k) {
    auto column = Q.col(k);
    for (int repeat = 0; repeat < 2; ++repeat) {
      const Coefficients r = Q.leftCols(k).transpose() * column;
      column.noalias() -= Q.leftCols(k) * r;
      for (int l = 0; l < k; ++l) R_[l * n + k] += r[l];
    }
    const double length = column.norm();
    if (!(length > kIllPlaced * std::sqrt(static_cast<double>(m)))) return false;
    R_[k * n + k] = length;
    column /= length;
  }
  return true;
}

std::span<const double> LocalPolynomial::Weights(int derivative) {
  CHECK_GE(derivative, 0);
  CHECK_LE(derivative, options_.order);
  if (derivative == derivative_) return {weights_.data(), size_};
  derivative_ = derivative;
  // c = R^-1 Q' y and the derivative is d! (2/w)^d c_d: weights = d! (2/w)^d Q (R^-T e_d).
  const int n = options_.order + 1;
  double x[kHighestOrder + 1];
  for (int k = 0; k < n; ++k) {
    double sum = k == derivative ? 1.0 : 0.0;
    for (int l = 0; l < k; ++l) sum -= R_[l * n + k] * x[l];
    x[k] = sum / R_[k * n + k];
  }
  double factor = 1.0;
  for (int d = 1; d <= derivative; ++d) factor *= d * 2.0 / options_.window;
  std::fill_n(weights_.begin(), size_, 0.0);
  for (int k = derivative; k < n; ++k) {
    const double* const column = &Q_[k * size_];
    for (size_t j = 0; j < size_; ++j) weights_[j] += factor * x[k] * column[j];
  }
  return {weights_.data(), size_};
}

double LocalPolynomial::Apply(std::span<const double> weights,
                              std::span<const double> values) const {
  const auto size = static_cast<Eigen::Index>(size_);
  return Eigen::VectorXd::Map(weights.data(), size)
      .dot(Eigen::VectorXd::Map(values.data() + first_, size));
}

std::vector<double> SavitzkyGolay(std::span<const double> time,
                                  std::span<const double> values,
                                  int derivative,
                                  const SavitzkyGolayOptions& options) {
  CHECK_EQ(time.size(), values.size());
  LocalPolynomial fit(time, options);
  std::vector<double> result(time.size(), kNaN);
  for (size_t i = 0; i < time.size(); ++i) {
    if (fit.MoveTo(i)) result[i] = fit.Apply(fit.Weights(derivative), values);
  }
  return result;
}

double ChooseWindow(std::span<const double> time,
                    std::span<const double> values,
                    int order,
                    double shortest,
                    double longest) {
  CHECK_EQ(time.size(), values.size());
  std::vector<double> windows, sums, counts;
  for (double window = shortest; window <= longest; window *= std::numbers::sqrt2) {
    windows.push_back(window);
  }
  if (windows.size() < 2) return shortest;
  sums.resize(windows.size());
  counts.resize(windows.size());
  // Only stamps well inside, where every window is centred, are compared.
  const double reach = 0.5 * windows.back();
  const size_t begin = LowerBound(time, time.front() + reach);
  const size_t end = LowerBound(time, time.back() - reach);
  const size_t stride = 1 + (end - std::min(begin, end)) / kMostScored;
  std::vector<double> near_time, near_values;  // about the sample
  std::vector<double> fitted_time;
  std::vector<LocalPolynomial> fits;  // one per window, at the sample
  std::vector<bool> is_fitted(windows.size());
  for (size_t i = begin; i < end; i += stride) {
    // The sample and those around it, but for its neighbours: noise that they share with it must
    // not predict it.
    near_time.clear();
    near_values.clear();
    size_t own = 0;
    for (size_t j = LowerBound(time, time[i] - 1.01 * reach);
         j < time.size() && time[j] <= time[i] + 1.01 * reach;
         ++j) {
      if (j != i && std::abs(time[j] - time[i]) <= kLeftOut * shortest) continue;
      if (j == i) own = near_time.size();
      near_time.push_back(time[j] - time[i]);
      near_values.push_back(values[j]);
    }
    if (!IsNear(near_time, fitted_time, kSamePlace * 0.5 * shortest)) {
      fits.clear();  // they view fitted_time
      fitted_time = near_time;
      for (const double window : windows) {
        LocalPolynomial& fit =
            fits.emplace_back(fitted_time, SavitzkyGolayOptions{.window = window, .order = order});
        is_fitted[fits.size() - 1] = fit.MoveTo(own);
      }
    }
    for (size_t k = 0; k < windows.size(); ++k) {
      if (!is_fitted[k]) continue;
      LocalPolynomial& fit = fits[k];
      const auto weights = fit.Weights(0);
      const double own_weight = weights[own - fit.first()];
      if (own_weight > 0.999) continue;  // nothing but the sample itself
      // What leaving the sample out would leave of it, without fitting again.
      sums[k] += std::abs(values[i] - fit.Apply(weights, near_values)) / (1.0 - own_weight);
      counts[k] += 1.0;
    }
  }
  const double enough = 0.5 * *std::max_element(counts.begin(), counts.end());
  double best = std::numeric_limits<double>::infinity();
  for (size_t k = 0; k < windows.size(); ++k) {
    if (counts[k] > enough) best = std::min(best, sums[k] / counts[k]);
  }
  for (size_t k = 0; k < windows.size(); ++k) {
    if (counts[k] > enough && sums[k] / counts[k] <= kTolerance * best) return windows[k];
  }
  return shortest;
}

}  // namespace fathom
