// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/trends/pattern_fit.h"

#include "fathom/base/chi_square.h"
#include "fathom/solve/decompositions.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>

namespace fathom {
namespace {

constexpr double kLeastFactor = -2.0;
constexpr double kMostFactor = 0.95;
constexpr int kNumFactors = 60;
constexpr int kNumSections = 40;
constexpr double kSizeThatCounts = 2.0;  // standard deviations

struct Linear {
  double misfit = 0.0;
  Eigen::VectorXd sizes;
  Eigen::MatrixXd information;  // of them
};

// (8) for a given f. The value before the event is uncertain too.
Linear FitSizes(const Eigen::MatrixXd& directions,
                const Eigen::VectorXd& share,
                const EventFit& event,
                double factor) {
  const Eigen::Index m = event.before.size();
  const Eigen::VectorXd gain = 1.0 / (1.0 - factor * share.array()) - 1.0;
  const Eigen::VectorXd rest = event.difference - gain.cwiseProduct(event.before);
  // Of that rest: difference less gain times before.
  const Eigen::MatrixXd shared = gain.asDiagonal() * event.covariance.topRightCorner(m, m);
  Eigen::MatrixXd covariance =
      gain.asDiagonal() * event.covariance.topLeftCorner(m, m) * gain.asDiagonal();
  covariance += event.covariance.bottomRightCorner(m, m) - shared - shared.transpose();
  const Eigen::LLT<Eigen::MatrixXd> whiten(covariance);
  const Eigen::VectorXd y = whiten.matrixL().solve(rest);
  Linear fit;
  fit.misfit = y.squaredNorm();
  if (directions.cols() == 0) return fit;
  const Eigen::MatrixXd x = whiten.matrixL().solve(directions);
  fit.information = x.transpose() * x;
  fit.sizes = fit.information.ldlt().solve(x.transpose() * y);
  fit.misfit = (y - x * fit.sizes).squaredNorm();
  return fit;
}

Eigen::VectorXd StdOf(const Eigen::MatrixXd& information) {
  return InverseOfSymmetric(information).diagonal().cwiseMax(0.0).cwiseSqrt();
}

// Each misfit is computed once: most of the time of naming a cause goes into them.
template <typename Function>
double Minimum(const Function& misfit) {
  const double step = (kMostFactor - kLeastFactor) / kNumFactors;
  double best = kLeastFactor;
  double least = misfit(best);
  for (int i = 1; i <= kNumFactors; ++i) {
    const double factor = kLeastFactor + step * i;
    const double value = misfit(factor);
    if (value < least) {
      best = factor;
      least = value;
    }
  }
  double low = std::max(best - step, kLeastFactor);
  double high = std::min(best + step, kMostFactor);
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  double a = high - golden * (high - low);
  double b = low + golden * (high - low);
  double misfit_a = misfit(a);
  double misfit_b = misfit(b);
  for (int i = 0; i < kNumSections; ++i) {
    if (misfit_a < misfit_b) {
      high = std::exchange(b, a);
      misfit_b = misfit_a;
      a = high - golden * (high - low);
      misfit_a = misfit(a);
    } else {
      low = std::exchange(a, b);
      misfit_a = misfit_b;
      b = low + golden * (high - low);
      misfit_b = misfit(b);
    }
  }
  return 0.5 * (low + high);
}

bool HasRightSign(const Pattern& pattern, const PatternFit& fit) {
  if (pattern.sign == PatternSign::kAny) return true;
  const double sign = pattern.sign == PatternSign::kGrows ? 1.0 : -1.0;
  if (pattern.HasFactor() && sign * fit.factor <= 0.0) return false;
  double sum = 0.0;
  for (Eigen::Index i = 0; i < fit.sizes.size(); ++i) {
    const double relative = sign * fit.sizes(i) / std::max(fit.size_std(i), 1e-300);
    if (relative < -kSizeThatCounts) return false;
    sum += relative;
  }
  return pattern.HasFactor() || sum > 0.0;
}

}  // namespace

PatternFit FitPattern(const Pattern& pattern, const EventFit& event, double price) {
  const Eigen::VectorXd share = pattern.share(event.series);
  const Eigen::MatrixXd rows = pattern.directions(event.series, Eigen::all);
  std::vector<int> used;
  for (int c = 0; c < rows.cols(); ++c) {
    if (!rows.col(c).isZero()) used.push_back(c);
  }
  const Eigen::MatrixXd directions = rows(Eigen::all, used);
  const bool has_factor = (share.array() != 0.0).any();
  PatternFit fit;
  const int num_free = static_cast<int>(used.size()) + (has_factor ? 1 : 0);
  if (num_free == 0) return fit;
  if (has_factor) {
    const auto misfit = [&](double f) { return FitSizes(directions, share, event, f).misfit; };
    fit.factor = Minimum(misfit);
    const double h = 1e-3;
    const double curvature =
        (misfit(fit.factor + h) - 2.0 * misfit(fit.factor) + misfit(fit.factor - h)) / (h * h);
    fit.factor_std = std::sqrt(2.0 / std::max(curvature, 1e-12));
  }
  const Linear linear = FitSizes(directions, share, event, fit.factor);
  fit.misfit = linear.misfit;
  fit.sizes = linear.sizes;
  fit.size_std = StdOf(linear.information);
  fit.p_value = ChiSquareTail(fit.misfit, static_cast<int>(event.before.size()) - num_free);
  fit.score = fit.misfit + price * num_free;
  fit.has_right_sign = HasRightSign(pattern, fit);
  return fit;
}

}  // namespace fathom
