// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/search/screen/significance.h"

#include "fathom/base/quantile.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fathom {
namespace {

// Probability that chi squared of 1 or 2 degrees of freedom exceeds `x`.
double Tail(int degrees, double x) {
  return degrees == 1 ? std::erfc(std::sqrt(0.5 * std::max(0.0, x))) : std::exp(-0.5 * x);
}

// 1 - (1 - p)^n, for the smallest p too.
double ChanceOfAny(double p, double n) {
  return -std::expm1(n * std::log1p(-std::min(p, 1.0 - 1e-12)));
}

// The n for which ChanceOfAny(p, n) is `any`.
double NumberFor(double p, double any) {
  return std::log1p(-any) / std::log1p(-std::clamp(p, 1e-300, 1.0 - 1e-12));
}

// Where a suspect's maxima are compared with chi squared: high enough that one-sided trials, whose
// gain is zero half of the time, have one; low enough for the draws to tell.
constexpr double kAnchor = 0.9;

constexpr double kRarerBeside = 15.0;

}  // namespace

Significance::Significance(const Eigen::MatrixXd& null_maxima,
                           std::vector<int> num_amounts,
                           const std::vector<double>& caution,
                           double false_alarm_rate)
    : num_amounts_(std::move(num_amounts)) {
  for (Eigen::Index k = 0; k < null_maxima.cols(); ++k) {
    const auto column = null_maxima.col(k);
    const double anchor = Quantile({column.begin(), column.end()}, kAnchor);
    const double p = Tail(num_amounts_[k], anchor);
    num_tests_.push_back(anchor > 0.0 ? NumberFor(p, 1.0 - kAnchor) : 0.0);
  }
  std::vector<double> rarest;
  for (Eigen::Index draw = 0; draw < null_maxima.rows(); ++draw) {
    double least = 1.0;
    for (Eigen::Index k = 0; k < null_maxima.cols(); ++k) {
      least = std::min(least, PValue(static_cast<int>(k), null_maxima(draw, k)));
    }
    rarest.push_back(least);
  }
  // The least p-value of n independent suspects has the 20 % quantile 1 - 0.8^(1/n).
  if (!rarest.empty()) num_families_ = std::max(1.0, NumberFor(Quantile(rarest, 0.2), 0.2));
  for (size_t k = 0; k < num_tests_.size(); ++k) num_tests_[k] *= caution[k];
  for (int k = 0; k < static_cast<int>(num_tests_.size()); ++k) {
    thresholds_.push_back(ThresholdAt(k, false_alarm_rate));
    thresholds_beside_.push_back(ThresholdAt(k, false_alarm_rate / kRarerBeside));
  }
}

double Significance::ThresholdAt(int suspect, double rate) const {
  double low = 0.0, high = 100.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (FamilyWisePValue(suspect, middle) > rate ? low : high) = middle;
  }
  return high;
}

double Significance::PValue(int suspect, double gain) const {
  // It leaves no trace on these logs.
  if (num_tests_.empty() || num_tests_[suspect] == 0.0) return 1.0;
  return ChanceOfAny(Tail(num_amounts_[suspect], gain), num_tests_[suspect]);
}

double Significance::FamilyWisePValue(int suspect, double gain) const {
  return ChanceOfAny(PValue(suspect, gain), num_families_);
}

}  // namespace fathom
