// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/processes/second_order_process.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glog/logging.h>

namespace fathom {
namespace {

// exp(A h) with A = [0 1; -stiffness -damping]: exp(mu h) (C I + S (A - mu I)), where
// C = cosh(delta h), S = sinh(delta h) / delta, delta^2 = mu^2 - stiffness.
Eigen::Matrix2d Exponential(const SecondOrderProcess& process, double h) {
  const double mu = -0.5 * process.damping;
  const double square = mu * mu - process.stiffness;
  const double x = square * h * h;
  double C, S;  // both with exp(mu h) in them
  if (std::abs(x) < 1e-6) {
    C = std::exp(mu * h) * (1.0 + 0.5 * x);
    S = std::exp(mu * h) * h * (1.0 + x / 6.0);
  } else if (square > 0.0) {
    const double delta = std::sqrt(square);
    const double slow = std::exp((mu + delta) * h), fast = std::exp((mu - delta) * h);
    C = 0.5 * (slow + fast);
    S = 0.5 * (slow - fast) / delta;
  } else {
    const double delta = std::sqrt(-square);
    C = std::exp(mu * h) * std::cos(delta * h);
    S = std::exp(mu * h) * std::sin(delta * h) / delta;
  }
  Eigen::Matrix2d Phi;
  Phi << C - mu * S, S, -process.stiffness * S, C - (process.damping + mu) * S;
  return Phi;
}

// Nodes and weights of Gauss-Legendre quadrature with 5 points on [-1, 1].
constexpr std::array<double, 5> kNodes = {
    -0.9061798459386640, -0.5384693101056831, 0.0, 0.5384693101056831, 0.9061798459386640};
constexpr std::array<double, 5> kWeights = {0.2369268850561891,
                                            0.4786286704993665,
                                            0.5688888888888889,
                                            0.4786286704993665,
                                            0.2369268850561891};

// Q = intensity * integral over [0, h] of b b', b the second column of exp(A s). Free of
// cancellation, unlike the difference of stationary covariances.
Eigen::Matrix2d IntegratedPush(const SecondOrderProcess& process, double h, double quickest) {
  constexpr double kPanel = 1.0;  // in time constants
  const int num_panels = std::max(1, static_cast<int>(std::ceil(quickest * h / kPanel)));
  const double half = 0.5 * h / num_panels;
  Eigen::Matrix2d Q = Eigen::Matrix2d::Zero();
  for (int panel = 0; panel < num_panels; ++panel) {
    for (size_t i = 0; i < kNodes.size(); ++i) {
      const double s = half * (2 * panel + 1 + kNodes[i]);
      const Eigen::Vector2d b = Exponential(process, s).col(1);
      Q += half * kWeights[i] * b * b.transpose();
    }
  }
  return process.intensity * Q;
}

}  // namespace

SecondOrderProcess SecondOrderProcess::Held(double std, double frequency, double ratio) {
  SecondOrderProcess process;
  process.stiffness = frequency * frequency;
  process.damping = 2.0 * ratio * frequency;
  process.intensity = 2.0 * process.damping * process.stiffness * std * std;
  return process;
}

Eigen::Matrix2d SecondOrderProcess::StationaryCovariance() const {
  CHECK_GT(stiffness, 0.0);
  const double rate_variance = intensity / (2.0 * damping);
  return Eigen::Vector2d(rate_variance / stiffness, rate_variance).asDiagonal();
}

Transition SecondOrderProcess::Over(double h) const {
  CHECK_GT(h, 0.0);
  CHECK(IsPresent());
  Transition transition;
  transition.Phi = Exponential(*this, h);
  // An upper bound of the quicker pole.
  const double quickest = std::max(damping, std::sqrt(stiffness));
  if (stiffness > 0.0 && quickest * h > 20.0) {
    const Eigen::Matrix2d P = StationaryCovariance();
    transition.Q = P - transition.Phi * P * transition.Phi.transpose();
  } else {
    transition.Q = IntegratedPush(*this, h, quickest);
  }
  const Eigen::Matrix2d& Q = transition.Q;
  const double l00 = std::sqrt(Q(0, 0));
  const double l10 = Q(1, 0) / l00;
  const double l11 = std::sqrt(Q(1, 1) - l10 * l10);
  transition.whitener << 1.0 / l00, 0.0, -l10 / (l00 * l11), 1.0 / l11;
  transition.log_det_Q = 2.0 * std::log(l00 * l11);
  return transition;
}

}  // namespace fathom
