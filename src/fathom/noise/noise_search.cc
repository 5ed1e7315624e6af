// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/noise/noise_search.h"

#include "fathom/base/parallel_for.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>

namespace fathom {
namespace {

constexpr int kMaxIterations = 100;
// So many steps in a row that raise the log-likelihood by less than is worthwhile end a search.
constexpr int kPatience = 3;
// Longest step in the logarithm of a parameter.
constexpr double kLongestStep = 2.0;
// So many samples that a likelihood takes far longer than a thread to begin.
constexpr Eigen::Index kWorthThreads = 500;
// Step of the differences in the logarithms of the parameters.
constexpr double kDifference = 1e-4;

// The damped Newton step; a parameter that presses against its bound stays there.
Eigen::VectorXd Step(const NoiseStructure& structure,
                     const Eigen::VectorXd& x,
                     Eigen::VectorXd gradient,
                     Eigen::MatrixXd curvature,
                     double damping) {
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    const bool is_held = (x[j] >= structure.upper()[j] && gradient[j] > 0.0) ||
                         (x[j] <= structure.lower()[j] && gradient[j] < 0.0);
    if (!is_held) continue;
    gradient[j] = 0.0;
    curvature.row(j).setZero();
    curvature.col(j).setZero();
    curvature(j, j) = 1.0;
  }
  curvature.diagonal() *= 1.0 + damping;
  const Eigen::VectorXd step = curvature.llt().solve(gradient);
  return step.cwiseMax(-kLongestStep).cwiseMin(kLongestStep);
}

// The BFGS update with Powell's guard against negative curvature.
void Improve(const Eigen::VectorXd& step,
             const Eigen::VectorXd& change,
             Eigen::MatrixXd* curvature) {
  const Eigen::VectorXd expected = *curvature * step;
  const double scale = step.dot(expected);
  if (!(scale > 0.0)) return;
  const double product = step.dot(change);
  const double share = product >= 0.2 * scale ? 1.0 : 0.8 * scale / (scale - product);
  const Eigen::VectorXd y = share * change + (1.0 - share) * expected;
  *curvature += y * y.transpose() / step.dot(y) - expected * expected.transpose() / scale;
}

}  // namespace

NoiseSearch::Point NoiseSearch::At(const NoiseStructure& structure, Eigen::VectorXd parameters) {
  ++num_evaluations_;
  RestrictedLikelihood::Value value = likelihood_.At(structure.Model(parameters));
  return {std::move(parameters), std::move(value)};
}

NoiseSearch::Result NoiseSearch::From(const NoiseStructure& structure,
                                      const Eigen::VectorXd& start,
                                      double worthwhile) {
  Result search{structure, At(structure, start)};
  const Eigen::Index m = structure.num_parameters();
  search.converged = m == 0;
  Eigen::VectorXd gradient;
  Eigen::MatrixXd curvature;
  if (m > 0) Differentiate(structure, search.best, &gradient, &curvature);
  // Of a parameter that the data do not determine nothing is known but that it should stay.
  curvature.diagonal().array() += 1e-2;
  double damping = 1e-3;
  int num_idle = 0;
  for (int i = 0; i < kMaxIterations && !search.converged; ++i) {
    const Eigen::VectorXd x = search.best.parameters;
    const Eigen::VectorXd step = Step(structure, x, gradient, curvature, damping);
    Point next = At(structure, (x + step).cwiseMax(structure.lower()).cwiseMin(structure.upper()));
    const double gain = next.value.log_likelihood - search.best.value.log_likelihood;
    const double promise = 0.5 * gradient.dot(step);
    search.converged = !(promise > worthwhile);
    if (!(gain > 0.0)) {
      damping = std::max(5.0 * damping, 0.05);
      continue;
    }
    search.best = std::move(next);
    num_idle = gain > worthwhile ? 0 : num_idle + 1;
    if (num_idle == kPatience) search.converged = true;
    if (gain > 0.5 * promise) damping = std::max(1e-6, 0.3 * damping);
    if (search.converged) break;
    const Eigen::VectorXd before = gradient;
    Differentiate(structure, search.best, &gradient, nullptr);
    Improve(search.best.parameters - x, before - gradient, &curvature);
  }
  return search;
}

void NoiseSearch::Differentiate(const NoiseStructure& structure,
                                const Point& at,
                                Eigen::VectorXd* gradient,
                                Eigen::MatrixXd* information) {
  using Column = Eigen::Map<const Eigen::VectorXd>;
  const Eigen::Index m = structure.num_parameters();
  const auto n = static_cast<Eigen::Index>(at.value.standardised.size());
  const Column e(at.value.standardised.data(), n), l(at.value.log_variances.data(), n);
  gradient->resize(m);
  Eigen::MatrixXd of_e, of_l;
  if (information != nullptr) {
    of_e.resize(n, m);
    of_l.resize(n, m);
  }
  const auto differentiate = [&](int j) {
    // Forward, or backward at the upper bound.
    const bool is_at_end = at.parameters[j] + kDifference > structure.upper()[j];
    const double step = is_at_end ? -kDifference : kDifference;
    Eigen::VectorXd shifted = at.parameters;
    shifted[j] += step;
    const RestrictedLikelihood::Value next = likelihood_.At(structure.Model(shifted));
    (*gradient)[j] = (next.log_likelihood - at.value.log_likelihood) / step;
    if (information == nullptr) return;
    of_l.col(j) = (Column(next.log_variances.data(), n) - l) / step;
    // The innovation's own change, in standard deviations: that of the whitened one less the part
    // that is the change of its standard deviation.
    const double ratio = next.factor / at.value.factor;
    of_e.col(j) = (ratio * Column(next.standardised.data(), n) - e) / step +
                  0.5 * e.cwiseProduct(of_l.col(j));
  };
  num_evaluations_ += static_cast<int>(m);
  if (n >= kWorthThreads) {
    ParallelFor(static_cast<int>(m), differentiate);
  } else {
    for (int j = 0; j < m; ++j) differentiate(j);
  }
  if (information == nullptr) return;
  const Eigen::VectorXd sum = of_l.colwise().sum();
  *information = of_e.transpose() * of_e + 0.5 * of_l.transpose() * of_l -
                 0.5 / static_cast<double>(n) * sum * sum.transpose();
}

}  // namespace fathom
