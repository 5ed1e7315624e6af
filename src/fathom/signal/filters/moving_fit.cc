// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/filters/moving_fit.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glog/logging.h>

namespace fathom {
namespace {

// The sums are about one origin while the window's middle is within this share of its width. They
// are then made anew, lest the rounding of what came and went adds up.
constexpr double kMostStray = 0.25;

// Of the normal equations: hardly two digits are lost, and LocalPolynomial stands in beyond. High
// orders need it.
constexpr double kSmallPivot = 2e-2;

// Derivative `derivative` of T_0 to T_order at `x`.
NormalEquations::Coefficients ChebyshevDerivatives(double x, int order, int derivative) {
  NormalEquations::Coefficients values = {}, of_lower_derivative = {};
  for (int d = 0; d <= derivative; ++d) {
    std::swap(values, of_lower_derivative);
    values[0] = d == 0 ? 1.0 : 0.0;
    values[1] = d == 0 ? x : d == 1 ? 1.0 : 0.0;
    for (int k = 1; k < order; ++k) {
      values[k + 1] = 2.0 * (x * values[k] + d * of_lower_derivative[k]) - values[k - 1];
    }
  }
  return values;
}

}  // namespace

MovingFit::MovingFit(std::span<const double> time,
                     std::vector<std::span<const double>> columns,
                     const SavitzkyGolayOptions& options)
    : time_(time),
      columns_(std::move(columns)),
      order_(options.order),
      stray_(kMostStray * options.window),
      reach_(0.5 * options.window + stray_),
      window_(time, options.window),
      stand_in_(time, options),
      column_sums_(columns_.size()),
      references_(columns_.size()),
      equations_(options.order) {
  for (const auto& column : columns_) CHECK_EQ(column.size(), time.size());
}

void MovingFit::Renew() {
  origin_ = window_.centre() + stray_;
  first_ = past_last_ = window_.first();
  sums_.fill(0.0);
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    column_sums_[c].fill(0.0);
    references_[c] = columns_[c][first_];
  }
}

template <int kOrder>
void MovingFit::CountUpTo(std::size_t sample, double sign) {
  const double x = (time_[sample] - origin_) / reach_;
  double T[2 * kOrder + 1];
  T[0] = sign;
  T[1] = sign * x;
  for (int k = 1; k < 2 * kOrder; ++k) T[k + 1] = 2.0 * x * T[k] - T[k - 1];
  for (int k = 0; k <= 2 * kOrder; ++k) sums_[k] += T[k];
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    const double y = columns_[c][sample] - references_[c];
    for (int k = 0; k <= kOrder; ++k) column_sums_[c][k] += T[k] * y;
  }
}

void MovingFit::Count(std::size_t sample, double sign) {
  // The usual order has loops of known length.
  if (order_ == 3) {
    CountUpTo<3>(sample, sign);
  } else {
    CountUpTo<kHighestOrder>(sample, sign);
  }
}

bool MovingFit::MoveTo(std::size_t i, int derivative) {
  CHECK_GE(derivative, 0);
  CHECK_LE(derivative, order_);
  window_.MoveTo(i);
  const bool is_near = std::abs(window_.centre() - origin_) <= stray_ &&
                       window_.first() >= first_ && window_.first() <= past_last_ &&
                       window_.past_last() >= past_last_;
  if (!is_near || past_last_ == first_) Renew();
  for (; past_last_ < window_.past_last(); ++past_last_) Count(past_last_, 1.0);
  for (; first_ < window_.first(); ++first_) Count(first_, -1.0);
  weights_ = {};
  if (!equations_.Factorize([this](int k, int l) { return 0.5 * (sums_[k + l] + sums_[k - l]); },
                            kSmallPivot)) {
    if (!stand_in_.MoveTo(i)) return false;
    weights_ = stand_in_.Weights(derivative);
    return true;
  }
  solution_ = ChebyshevDerivatives((time_[i] - origin_) / reach_, order_, derivative);
  equations_.Solve(&solution_);
  for (int d = 0; d < derivative; ++d) {
    for (double& coefficient : solution_) coefficient /= reach_;
  }
  adds_reference_ = derivative == 0;
  return true;
}

double MovingFit::Estimate(std::size_t column) const {
  if (!weights_.empty()) return stand_in_.Apply(weights_, columns_[column]);
  double sum = adds_reference_ ? references_[column] : 0.0;
  for (int k = 0; k <= order_; ++k) sum += solution_[k] * column_sums_[column][k];
  return sum;
}

}  // namespace fathom
