// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/trends/scan.h"

#include "fathom/solve/decompositions.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>

namespace fathom {
namespace {

// A quarter of a unit of log variance is 13 % of a standard deviation.
constexpr double kLogVarianceStep = 0.25;
constexpr int kMostTaus = 24;
constexpr double kLeastFreedom = 2.0;
constexpr double kLeastShareOfItsOwn = 1e-7;  // of a candidate that the model's columns do not hold

// tau^2 so that the logarithm of variance + tau^2 rises evenly, up to twice the variance of the
// values.
std::vector<double> TauGrid(const DiveSeries& series) {
  std::vector<double> variances(series.variance.begin(), series.variance.end());
  std::nth_element(variances.begin(), variances.begin() + variances.size() / 4, variances.end());
  const double small = variances[variances.size() / 4];
  const double mean = series.value.mean();
  const double spread =
      (series.value.array() - mean).square().sum() / static_cast<double>(series.value.size());
  const double range = std::log1p(std::max(3.0, 2.0 * spread / small));
  const int size = std::min(kMostTaus, 1 + static_cast<int>(std::ceil(range / kLogVarianceStep)));
  std::vector<double> grid;
  for (int i = 0; i < size; ++i) grid.push_back(small * std::expm1(range * i / (size - 1)));
  return grid;
}

bool LeavesTwoDivesOnEitherSide(int place, int num_dives, const std::vector<int>& places) {
  if (place < 2 || num_dives - place < 2) return false;
  return std::none_of(
      places.begin(), places.end(), [&](int other) { return std::abs(place - other) < 2; });
}

// Where the steps of a model stand among the dives of the series.
std::vector<int> PlacesOf(const DiveSeries& series, std::span<const Column> model) {
  std::vector<int> places;
  for (const Column& column : model) {
    if (column.kind == ChangeKind::kTrend) continue;
    const auto first = std::lower_bound(series.dive.begin(), series.dive.end(), column.at);
    places.push_back(static_cast<int>(first - series.dive.begin()));
  }
  return places;
}

double Gain(double own, double total) {
  return own > kLeastShareOfItsOwn * total && own > 0.0 ? 1.0 / own : 0.0;
}

Eigen::VectorXd Gains(const ScanAtTau& at, const Eigen::VectorXd& trend) {
  const Eigen::Index n = at.root_weight.size();
  const Eigen::VectorXd weight = at.root_weight.cwiseAbs2();
  Eigen::VectorXd gain = Eigen::VectorXd::Zero(2 * n);
  Eigen::VectorXd in_model = Eigen::VectorXd::Zero(at.basis.cols());
  double total = 0.0;
  for (Eigen::Index k = n - 2; k >= 0; --k) {
    total += weight(k + 1);
    in_model += at.root_weight(k + 1) * at.basis.row(k + 1).transpose();
    gain(k) = Gain(total - in_model.squaredNorm(), total);
  }
  const Eigen::VectorXd weighted = at.root_weight.cwiseProduct(trend);
  gain(n - 1) = Gain(weighted.squaredNorm() - (at.basis.transpose() * weighted).squaredNorm(),
                     weighted.squaredNorm());
  for (Eigen::Index i = 0; i < n; ++i) {
    gain(n + i) = Gain(weight(i) * (1.0 - at.basis.row(i).squaredNorm()), weight(i));
  }
  return gain;
}

ScanAtTau AtTau(const DiveSeries& series,
                const Eigen::MatrixXd& design,
                const Eigen::VectorXd& trend,
                double tau_squared) {
  ScanAtTau at;
  at.tau_squared = tau_squared;
  const Eigen::ArrayXd variance = series.variance.array() + tau_squared;
  at.log_det = variance.log().sum();
  at.root_weight = variance.rsqrt();
  const Eigen::MatrixXd weighted = at.root_weight.asDiagonal() * design;
  ColumnSpace space = ColumnSpaceOf(weighted, 1e-9);
  at.log_det_information = 2.0 * space.pivots.array().abs().log().sum();
  at.basis = std::move(space.basis);
  at.gain = Gains(at, trend);
  return at;
}

}  // namespace

ScanDesign MakeScanDesign(const DiveSeries& series, std::span<const Column> model, int num_dives) {
  ScanDesign design;
  design.num_dives = static_cast<int>(series.dive.size());
  const int n = design.num_dives;
  const Column trend{ChangeKind::kTrend, 0};
  design.trend = DesignMatrix(series, std::span(&trend, 1), num_dives).col(1);
  const Eigen::MatrixXd columns = DesignMatrix(series, model, num_dives);
  for (const double tau_squared : TauGrid(series)) {
    design.at_tau.push_back(AtTau(series, columns, design.trend, tau_squared));
  }
  const std::vector<int> places = PlacesOf(series, model);
  for (ScanAtTau& at : design.at_tau) {
    for (int k = 0; k < n - 1; ++k) {
      if (!LeavesTwoDivesOnEitherSide(k + 1, n, places)) at.gain(k) = 0.0;
    }
  }
  design.freedom = n - design.at_tau[0].basis.cols() - 1.0;
  if (design.freedom < kLeastFreedom) {
    for (ScanAtTau& at : design.at_tau) at.gain.setZero();
    design.freedom = kLeastFreedom;
  }
  for (ScanAtTau& at : design.at_tau) {
    at.half_log_gain = (at.gain.array() > 0.0).select(0.5 * at.gain.array().log(), 0.0);
  }
  return design;
}

ScanResult Scan(const ScanDesign& design, const Eigen::VectorXd& value) {
  const Eigen::Index n = design.num_dives;
  ScanResult result;
  result.log_likelihood = -std::numeric_limits<double>::infinity();
  double best_restricted = result.log_likelihood;
  Eigen::ArrayXd best = Eigen::ArrayXd::Constant(2 * n, result.log_likelihood);
  Eigen::ArrayXd best_square = Eigen::ArrayXd::Zero(2 * n);
  result.candidate_tau_squared = Eigen::ArrayXd::Zero(2 * n);
  Eigen::VectorXd weighted(n);
  Eigen::VectorXd residual(n);
  Eigen::ArrayXd square(2 * n);  // (c' P y)^2 / (c' P c) of each candidate
  for (const ScanAtTau& at : design.at_tau) {
    weighted = at.root_weight.cwiseProduct(value);
    residual = weighted;
    for (Eigen::Index p = 0; p < at.basis.cols(); ++p) {
      residual -= at.basis.col(p).dot(weighted) * at.basis.col(p);
    }
    const double log_likelihood = -0.5 * (residual.squaredNorm() + at.log_det);
    const double restricted = log_likelihood - 0.5 * at.log_det_information;
    if (restricted > best_restricted) {
      best_restricted = restricted;
      result.tau_squared = at.tau_squared;
    }
    result.log_likelihood = std::max(result.log_likelihood, log_likelihood);
    residual = residual.cwiseProduct(at.root_weight);
    square.tail(n) = residual;
    square(n - 1) = residual.dot(design.trend);
    double sum = 0.0;
    for (Eigen::Index k = n - 2; k >= 0; --k) square(k) = sum += residual(k + 1);
    square = square.square() * at.gain.array();
    for (Eigen::Index c = 0; c < 2 * n; ++c) {
      const double with = restricted + 0.5 * square(c) + at.half_log_gain(c);
      if (with <= best(c)) continue;
      best(c) = with;
      best_square(c) = square(c);
      result.candidate_tau_squared(c) = at.tau_squared;
    }
  }
  // Close to z^2 for t^2 of so many degrees of freedom (Wallace 1959).
  result.statistic = (1.0 + best_square / design.freedom).log() * (design.freedom - 0.5);
  return result;
}

ScanCandidate BestChange(const ScanResult& scan) {
  const Eigen::Index n = scan.statistic.size() / 2;
  Eigen::Index index = 0;
  const double statistic = scan.statistic.head(n).maxCoeff(&index);
  return statistic > 0.0 ? ScanCandidate{static_cast<int>(index), statistic} : ScanCandidate{};
}

ScanCandidate BestDive(const ScanResult& scan) {
  const Eigen::Index n = scan.statistic.size() / 2;
  Eigen::Index index = 0;
  const double statistic = scan.statistic.tail(n).maxCoeff(&index);
  return statistic > 0.0 ? ScanCandidate{static_cast<int>(n + index), statistic} : ScanCandidate{};
}

int CandidateOf(const DiveSeries& series, const Column& column) {
  const int n = static_cast<int>(series.dive.size());
  if (column.kind == ChangeKind::kTrend) return n - 1;
  const auto first = std::lower_bound(series.dive.begin(), series.dive.end(), column.at);
  return static_cast<int>(first - series.dive.begin()) - 1;
}

Column ColumnOf(const DiveSeries& series, int candidate) {
  const int n = static_cast<int>(series.dive.size());
  if (candidate == n - 1) return {ChangeKind::kTrend, series.dive.front()};
  return {ChangeKind::kStep, series.dive[candidate + 1]};
}

}  // namespace fathom
