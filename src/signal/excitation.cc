// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/excitation.h"

#include "fathom/signal/integral.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <glog/logging.h>

namespace fathom {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kMostBins = 2048;
constexpr double kRankThreshold = 1e-12;

// The command's means over equal bins, less their mean.
struct Bins {
  double width = 0.0;  // [s]
  Eigen::VectorXd value;
};

Bins BinsOf(const HeldCommand& command, double duration) {
  const int n = std::clamp(static_cast<int>(2 * command.time.size()), 16, kMostBins);
  Bins bins;
  bins.width = duration / n;
  std::vector<double> edges(n + 1);
  for (int i = 0; i <= n; ++i) edges[i] = command.time.front() + i * bins.width;
  const std::vector<double> integral = IntegralsOf(command, edges).once;
  bins.value.resize(n);
  for (int i = 0; i < n; ++i) bins.value[i] = (integral[i + 1] - integral[i]) / bins.width;
  bins.value.array() -= bins.value.mean();
  return bins;
}

// Share of the sum of squares that a constant and a sine of `frequency` explain.
double ShareAt(const Bins& bins, double frequency) {
  const auto step = std::polar(1.0, frequency * bins.width);
  std::complex<double> phase = 1.0;
  double c = 0.0, s = 0.0, cc = 0.0, cs = 0.0, ss = 0.0, yc = 0.0, ys = 0.0;
  for (const double y : bins.value) {
    c += phase.real();
    s += phase.imag();
    cc += phase.real() * phase.real();
    cs += phase.real() * phase.imag();
    ss += phase.imag() * phase.imag();
    yc += y * phase.real();
    ys += y * phase.imag();
    phase = {phase.real() * step.real() - phase.imag() * step.imag(),
             phase.real() * step.imag() + phase.imag() * step.real()};
  }
  const auto n = static_cast<double>(bins.value.size());
  Eigen::Matrix2d gram;
  gram << cc - c * c / n, cs - c * s / n, cs - c * s / n, ss - s * s / n;
  const Eigen::Vector2d right(yc, ys);  // the values have mean 0
  return right.dot(gram.ldlt().solve(right)) / bins.value.squaredNorm();
}

}  // namespace

Excitation ExcitationOf(const Eigen::MatrixXd& sensitivity, const std::vector<std::string>& names) {
  const Eigen::Index k = sensitivity.cols();
  CHECK_EQ(static_cast<size_t>(k), names.size());
  CHECK_GE(sensitivity.rows(), k);
  Eigen::VectorXd length = sensitivity.colwise().norm();
  const Eigen::VectorXd scale = length.unaryExpr([](double x) { return x > 0.0 ? 1.0 / x : 0.0; });
  // The triangle of a QR decomposition has the angles between the columns, in k rows.
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(sensitivity * scale.asDiagonal());
  const Eigen::MatrixXd R = qr.matrixQR().topRows(k).triangularView<Eigen::Upper>();
  const Eigen::VectorXd S = Eigen::JacobiSVD<Eigen::MatrixXd>(R).singularValues();

  Excitation excitation;
  excitation.condition_number =
      S[k - 1] > kRankThreshold * S[0] ? S[0] / S[k - 1] : std::numeric_limits<double>::infinity();
  for (Eigen::Index j = 0; j < k; ++j) {
    ParameterExcitation parameter = {.name = names[j]};
    if (length[j] > 0.0) {
      Eigen::MatrixXd others = R;
      others.col(j).setZero();
      Eigen::ColPivHouseholderQR<Eigen::MatrixXd> projection(others);
      projection.setThreshold(kRankThreshold);
      const Eigen::VectorXd left = R.col(j) - others * projection.solve(R.col(j));
      parameter.surviving_share = left.norm();
    }
    excitation.parameters.push_back(parameter);
  }
  return excitation;
}

Tone DominantTone(const HeldCommand& command, double duration) {
  CHECK(!command.time.empty());
  CHECK_GT(duration, 0.0);
  const auto [least, most] = std::minmax_element(command.value.begin(), command.value.end());
  if (*least == *most) return {};
  const Bins bins = BinsOf(command, duration);
  if (!(bins.value.squaredNorm() > 0.0)) return {};

  const double step = 0.5 * kPi / duration;
  const double highest = 0.5 * kPi / bins.width;
  Tone tone = {2.0 * step, 0.0};
  for (double frequency = 2.0 * step; frequency < highest; frequency += step) {
    const double share = ShareAt(bins, frequency);
    if (share > tone.share) tone = {frequency, share};
  }
  // Golden section between the neighbours on the grid.
  double from = tone.frequency - step, to = tone.frequency + step;
  const double ratio = 1.0 / std::numbers::phi;
  while (to - from > 1e-4 * step) {
    const double a = to - ratio * (to - from), b = from + ratio * (to - from);
    if (ShareAt(bins, a) > ShareAt(bins, b)) {
      to = b;
    } else {
      from = a;
    }
  }
  tone.frequency = 0.5 * (from + to);
  tone.share = std::clamp(ShareAt(bins, tone.frequency), 0.0, 1.0);
  return tone;
}

}  // namespace fathom
