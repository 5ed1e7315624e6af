// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/filters/local_polynomial.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>
#include <glog/logging.h>

namespace fathom {
namespace {

// Samples that stand this near to where the last window's stood, as a share of half the window,
// have its weights: equal steps, but for the rounding of stamps of up to a day.
constexpr double kSamePlace = 1e-9;

// A column of the monomials adds nothing if what the lower ones leave of it is below this share of
// what it would be at the window's edge.
constexpr double kIllPlaced = 1e-7;

// One per power of the polynomial.
using Coefficients = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kHighestOrder + 1, 1>;

}  // namespace

LocalPolynomial::LocalPolynomial(std::span<const double> time, const SavitzkyGolayOptions& options)
    : time_(time), options_(options), window_(time, options.window) {
  CHECK_GE(options.order, 0);
  CHECK_LE(options.order, kHighestOrder);
  R_.resize(static_cast<size_t>(options.order + 1) * (options.order + 1));
}

bool LocalPolynomial::MoveTo(size_t i) {
  window_.MoveTo(i);
  if (PlaceSamples(time_[i])) {
    derivative_ = -1;
    is_factorized_ = Factorize();
  }
  return is_factorized_;
}

// False if the samples stand where they stood in the last window.
bool LocalPolynomial::PlaceSamples(double t) {
  const double scale = 2.0 / options_.window;
  const auto samples = time_.subspan(window_.first(), window_.size());
  const auto is_near = [&](double stamp, double place) {
    return std::abs((stamp - t) * scale - place) <= kSamePlace;
  };
  if (std::equal(samples.begin(), samples.end(), place_.begin(), place_.end(), is_near)) {
    return false;
  }
  place_.resize(samples.size());
  for (size_t j = 0; j < samples.size(); ++j) place_[j] = (samples[j] - t) * scale;
  return true;
}

// Gram-Schmidt, each column twice, of the monomials in place_.
bool LocalPolynomial::Factorize() {
  const int n = options_.order + 1;
  const size_t m = window_.size();
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
  const size_t m = window_.size();
  if (derivative == derivative_) return {weights_.data(), m};
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
  std::fill_n(weights_.begin(), m, 0.0);
  for (int k = derivative; k < n; ++k) {
    const double* const column = &Q_[k * m];
    for (size_t j = 0; j < m; ++j) weights_[j] += factor * x[k] * column[j];
  }
  return {weights_.data(), m};
}

double LocalPolynomial::Apply(std::span<const double> weights,
                              std::span<const double> values) const {
  const auto size = static_cast<Eigen::Index>(window_.size());
  return Eigen::VectorXd::Map(weights.data(), size)
      .dot(Eigen::VectorXd::Map(values.data() + window_.first(), size));
}

}  // namespace fathom
