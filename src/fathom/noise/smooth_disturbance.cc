// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/noise/smooth_disturbance.h"

#include "fathom/noise/noise_dynamics.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <Eigen/Core>
#include <glog/logging.h>

namespace fathom {
namespace {

using State = Eigen::Matrix<double, 5, 1>;  // (w, v', x', c, c_x)
using Matrix = Eigen::Matrix<double, 5, 5>;

Matrix TransitionMatrix(const NoiseTransition& t) {
  Matrix F = Matrix::Zero();
  F.diagonal() << t.w_from_w, t.v_from_v, 1.0, t.velocity_c, t.displacement_c;
  F(1, 0) = t.v_from_w;
  F(2, 0) = t.x_from_w;
  F(2, 1) = t.x_from_v;
  return F;
}

Matrix NoiseCovariance(const NoiseTransition& t) {
  Matrix Q = Matrix::Zero();
  Q.diagonal() << t.q_ww, t.q_vv, t.q_xx, t.q_velocity_c, t.q_displacement_c;
  Q(0, 1) = Q(1, 0) = t.q_wv;
  Q(0, 2) = Q(2, 0) = t.q_wx;
  Q(1, 2) = Q(2, 1) = t.q_vx;
  return Q;
}

Matrix StartCovariance(const NoiseModel& model, const NoiseDynamics& dynamics) {
  Matrix P = Matrix::Zero();
  P.diagonal() << dynamics.var_w(), dynamics.var_v(), 0.0, std::pow(model.velocity.coloured.std, 2),
      std::pow(model.displacement.coloured.std, 2);
  P(0, 1) = P(1, 0) = dynamics.cov_wv();
  return P;
}

// What the filter knows at a sample before it has seen it, and what it then sees.
struct Prediction {
  Matrix from_before;  // transition from the sample before; unused at the start of a segment
  State mean;
  Matrix covariance;
  State seen;           // the row of the observation
  double innovation;    // less its prediction
  double variance;      // of the innovation
  State filtered_gain;  // P seen / variance
};

// Forward: the Kalman filter, docs/residual_noise.md (7).
std::vector<Prediction> Filter(const NoiseModel& model,
                               std::span<const NoiseSample> samples,
                               std::span<const double> residual) {
  const size_t n = samples.size();
  std::map<double, NoiseDynamics> regimes;  // by damping factor
  const NoiseDynamics& usual = regimes.try_emplace(1.0, model).first->second;
  std::vector<Prediction> predictions(n);
  State mean = State::Zero();
  Matrix P = Matrix::Zero();
  for (size_t i = 0; i < n; ++i) {
    const NoiseSample& sample = samples[i];
    Prediction& at = predictions[i];
    if (i == 0 || sample.segment != samples[i - 1].segment) {
      at.from_before.setZero();
      mean.setZero();
      P = StartCovariance(model, usual);
    } else {
      const double dt = sample.time - samples[i - 1].time;
      CHECK(dt >= 0.0 && std::isfinite(dt)) << "Samples out of order at time " << sample.time;
      const double factor = sample.damping_factor;
      const NoiseDynamics& dynamics = regimes.try_emplace(factor, model, factor).first->second;
      const NoiseTransition transition = dynamics.Over(dt);
      at.from_before = TransitionMatrix(transition);
      mean = at.from_before * mean;
      P = at.from_before * P * at.from_before.transpose() + NoiseCovariance(transition);
    }
    const bool is_velocity = sample.channel == NoiseChannel::kVelocity;
    const SensorNoise& sensor = is_velocity ? model.velocity : model.displacement;
    at.mean = mean;
    at.covariance = P;
    at.seen = State::Unit(is_velocity ? 1 : 2) + State::Unit(is_velocity ? 3 : 4);
    at.innovation = residual[i] - at.seen.dot(mean);
    at.variance =
        at.seen.dot(P * at.seen) + sample.variance_factor * sensor.white_std * sensor.white_std;
    CHECK(at.variance > 0.0) << "A sample without a variance of its own: " << at.variance << ".";
    at.filtered_gain = P * at.seen / at.variance;
    mean += at.filtered_gain * at.innovation;
    P -= at.variance * at.filtered_gain * at.filtered_gain.transpose();
  }
  return predictions;
}

// Backward: what later samples add, docs/residual_noise.md (10). No covariance is inverted: that of
// x' is singular at its start.
SmoothedDisturbance Smooth(std::span<const NoiseSample> samples,
                           const std::vector<Prediction>& predictions) {
  const size_t n = samples.size();
  SmoothedDisturbance smoothed{std::vector<double>(n), std::vector<double>(n)};
  State r = State::Zero();
  Matrix N = Matrix::Zero();
  for (size_t i = n; i-- > 0;) {
    const Prediction& at = predictions[i];
    const bool ends_segment = i + 1 == n || samples[i + 1].segment != samples[i].segment;
    if (ends_segment) {
      r.setZero();
      N.setZero();
    } else {
      const Matrix& F = predictions[i + 1].from_before;
      r = F.transpose() * r;
      N = F.transpose() * N * F;
    }
    const Matrix rest = Matrix::Identity() - at.filtered_gain * at.seen.transpose();
    r = at.seen * (at.innovation / at.variance) + rest.transpose() * r;
    N = at.seen * at.seen.transpose() / at.variance + rest.transpose() * N * rest;
    const auto from_w = at.covariance.row(0);
    smoothed.mean[i] = at.mean(0) + from_w * r;
    const double variance = at.covariance(0, 0) - from_w * N * from_w.transpose();
    smoothed.std[i] = std::sqrt(std::max(0.0, variance));
  }
  return smoothed;
}

}  // namespace

SmoothedDisturbance SmoothDisturbance(const NoiseModel& model,
                                      std::span<const NoiseSample> samples,
                                      std::span<const double> residual) {
  CHECK_EQ(samples.size(), residual.size());
  return Smooth(samples, Filter(model, samples, residual));
}

}  // namespace fathom
