// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cmath>
#include <span>

#include <Eigen/Dense>

namespace fathom {

// What one would write by hand for one log on one uniform clock: output error by Gauss-Newton with
// hand-coded sensitivities, no bounds, no robust loss, no covariance. The peer of bench/.
struct GaussNewton {
  std::span<const double> force;     // [N], held over each step
  std::span<const double> velocity;  // [m/s]
  double step = 0.02;                // [s]

  using Parameters = Eigen::Matrix<double, 5, 1>;  // m, d_Q, d_L, b, v(0)

  // Fills the normal equations at `p`; returns the sum of squares.
  double Accumulate(const Parameters& p, Eigen::Matrix<double, 5, 5>* JtJ, Parameters* Jtr) const {
    JtJ->setZero();
    Jtr->setZero();
    const double inverse_m = 1.0 / p[0], d_Q = p[1], d_L = p[2], b = p[3], h = step;
    double v = p[4], cost = 0.0;
    std::array<double, 5> s = {0.0, 0.0, 0.0, 0.0, 1.0};
    const auto slope = [&](double speed,
                           const std::array<double, 5>& sensitivity,
                           double tau,
                           std::array<double, 5>* ds) {
      const double quadratic = speed * std::abs(speed);
      const double a = (tau - d_Q * quadratic - d_L * speed - b) * inverse_m;
      const double da_dv = -(2.0 * d_Q * std::abs(speed) + d_L) * inverse_m;
      (*ds)[0] = da_dv * sensitivity[0] - a * inverse_m;
      (*ds)[1] = da_dv * sensitivity[1] - quadratic * inverse_m;
      (*ds)[2] = da_dv * sensitivity[2] - speed * inverse_m;
      (*ds)[3] = da_dv * sensitivity[3] - inverse_m;
      (*ds)[4] = da_dv * sensitivity[4];
      return a;
    };
    const auto moved =
        [](const std::array<double, 5>& from, double by, const std::array<double, 5>& along) {
          std::array<double, 5> to;
          for (int j = 0; j < 5; ++j) to[j] = from[j] + by * along[j];
          return to;
        };
    for (size_t i = 0; i < velocity.size(); ++i) {
      const double r = v - velocity[i];
      cost += r * r;
      for (int j = 0; j < 5; ++j) {
        (*Jtr)[j] += s[j] * r;
        for (int k = 0; k <= j; ++k) (*JtJ)(j, k) += s[j] * s[k];
      }
      const double tau = force[i];
      std::array<double, 5> s1, s2, s3, s4;
      const double k1 = slope(v, s, tau, &s1);
      const double k2 = slope(v + 0.5 * h * k1, moved(s, 0.5 * h, s1), tau, &s2);
      const double k3 = slope(v + 0.5 * h * k2, moved(s, 0.5 * h, s2), tau, &s3);
      const double k4 = slope(v + h * k3, moved(s, h, s3), tau, &s4);
      v += h / 6.0 * (k1 + 2.0 * (k2 + k3) + k4);
      for (int j = 0; j < 5; ++j) s[j] += h / 6.0 * (s1[j] + 2.0 * (s2[j] + s3[j]) + s4[j]);
    }
    return cost;
  }

  Parameters Fit(Parameters p, int* num_iterations) const {
    for (*num_iterations = 1; *num_iterations < 50; ++*num_iterations) {
      Eigen::Matrix<double, 5, 5> JtJ;
      Parameters Jtr;
      Accumulate(p, &JtJ, &Jtr);
      const Parameters change = JtJ.selfadjointView<Eigen::Lower>().ldlt().solve(-Jtr);
      p += change;
      if (change.norm() < 1e-9 * p.norm()) break;
    }
    return p;
  }
};

}  // namespace fathom
