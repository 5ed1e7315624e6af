// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/noise/noise_dynamics.h"

#include <algorithm>
#include <cmath>

#include <glog/logging.h>

namespace fathom {
namespace {

// Longest interval of the series, in time constants. The series of Q goes with twice the rate; its
// first term left out is then 1 / 17!, 3e-15.
constexpr double kLongestOfSeries = 0.5;

// F and Q over twice the interval: F F and F Q F' + Q.
NoiseTransition Doubled(const NoiseTransition& t) {
  NoiseTransition d = t;
  d.w_from_w = t.w_from_w * t.w_from_w;
  d.v_from_w = t.v_from_w * t.w_from_w + t.v_from_v * t.v_from_w;
  d.v_from_v = t.v_from_v * t.v_from_v;
  d.x_from_w = t.x_from_w * t.w_from_w + t.x_from_v * t.v_from_w + t.x_from_w;
  d.x_from_v = t.x_from_v * t.v_from_v + t.x_from_v;
  // F Q, whose rows are then multiplied with those of F.
  const double ww = t.w_from_w * t.q_ww;
  const double vw = t.v_from_w * t.q_ww + t.v_from_v * t.q_wv;
  const double vv = t.v_from_w * t.q_wv + t.v_from_v * t.q_vv;
  const double xw = t.x_from_w * t.q_ww + t.x_from_v * t.q_wv + t.q_wx;
  const double xv = t.x_from_w * t.q_wv + t.x_from_v * t.q_vv + t.q_vx;
  const double xx = t.x_from_w * t.q_wx + t.x_from_v * t.q_vx + t.q_xx;
  d.q_ww += ww * t.w_from_w;
  d.q_wv += vw * t.w_from_w;
  d.q_vv += vw * t.v_from_w + vv * t.v_from_v;
  d.q_wx += xw * t.w_from_w;
  d.q_vx += xw * t.v_from_w + xv * t.v_from_v;
  d.q_xx += xw * t.x_from_w + xv * t.x_from_v + xx;
  return d;
}

}  // namespace

double NoiseModel::DisturbedVelocityStd() const {
  if (!disturbance.IsPresent()) return 0.0;
  const double rate = damping_rate + 1.0 / disturbance.time;
  return disturbance.std / std::sqrt(damping_rate * rate);
}

NoiseDynamics::NoiseDynamics(const NoiseModel& model, double damping_factor) : model_(model) {
  if (!model.disturbance.IsPresent()) return;
  const double a = damping_factor * model.damping_rate;
  const double b = 1.0 / model.disturbance.time;
  CHECK_GT(a, 0.0) << "A disturbed velocity without damping is not stationary.";
  CHECK_GT(model.disturbance.time, 0.0);
  fastest_rate_ = std::max(a, b);
  var_w_ = model.disturbance.std * model.disturbance.std;
  cov_wv_ = var_w_ / (a + b);
  var_v_ = cov_wv_ / a;

  // docs/residual_noise.md (5): dF/dt = A F from the identity, (6): dQ/dt = A Q + Q A' + G from 0.
  series_[0] = {1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  for (int k = 0; k + 1 < kNumTerms; ++k) {
    const auto [f_ww, f_vw, f_vv, f_xw, f_xv, q_ww, q_wv, q_vv, q_wx, q_vx, q_xx] = series_[k];
    const double spectral_density = k == 0 ? 2.0 * b * var_w_ : 0.0;
    series_[k + 1] = {-b * f_ww,
                      f_ww - a * f_vw,
                      -a * f_vv,
                      f_vw,
                      f_vv,
                      -2.0 * b * q_ww + spectral_density,
                      q_ww - (a + b) * q_wv,
                      2.0 * q_wv - 2.0 * a * q_vv,
                      q_wv - b * q_wx,
                      q_vv + q_wx - a * q_vx,
                      2.0 * q_vx};
    for (double& entry : series_[k + 1]) entry /= k + 1;
  }
}

NoiseTransition NoiseDynamics::Over(double dt) const {
  NoiseTransition t;
  if (var_w_ > 0.0) {
    int num_doublings = 0;
    double h = dt;
    for (; h * fastest_rate_ > kLongestOfSeries; h *= 0.5) ++num_doublings;
    Entries sum = series_[kNumTerms - 1];
    for (int k = kNumTerms - 1; k-- > 0;) {
      for (size_t j = 0; j < sum.size(); ++j) sum[j] = sum[j] * h + series_[k][j];
    }
    t.w_from_w = sum[0];
    t.v_from_w = sum[1];
    t.v_from_v = sum[2];
    t.x_from_w = sum[3];
    t.x_from_v = sum[4];
    t.q_ww = sum[5];
    t.q_wv = sum[6];
    t.q_vv = sum[7];
    t.q_wx = sum[8];
    t.q_vx = sum[9];
    t.q_xx = sum[10];
    for (int i = 0; i < num_doublings; ++i) t = Doubled(t);
  }
  const auto coloured = [dt](const OrnsteinUhlenbeck& noise, double* decay, double* variance) {
    if (!noise.IsPresent()) return;
    *decay = std::exp(-dt / noise.time);
    *variance = -noise.std * noise.std * std::expm1(-2.0 * dt / noise.time);
  };
  coloured(model_.velocity.coloured, &t.velocity_c, &t.q_velocity_c);
  coloured(model_.displacement.coloured, &t.displacement_c, &t.q_displacement_c);
  return t;
}

}  // namespace fathom
