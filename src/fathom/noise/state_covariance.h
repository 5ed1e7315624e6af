// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/noise/filter_states.h"
#include "fathom/noise/noise_dynamics.h"
#include "fathom/noise/whitening_step.h"

#include <array>
#include <cmath>

#include <Eigen/Core>
#include <glog/logging.h>

namespace fathom {

// The covariance of a filter's states and what time and samples do to it; docs/residual_noise.md
// (7). Only its lower half is filled.
template <typename States>
struct StateCovariance : States {
  using States::ForSeen, States::kNumStates;
  using States::kC, States::kCx, States::kV, States::kW, States::kX;
  using States::kHasC, States::kHasCx, States::kHasV, States::kHasX;
  using Covariance = Eigen::Matrix<double, kNumStates, kNumStates>;

  // Samples of one kind before which the state is as uncertain as it was before the last one of
  // that kind, to this relative precision, share their gains: the filter is stationary.
  static constexpr double kStationary = 1e-13;

  static bool IsSame(const Covariance& P, const Covariance& other) {
    for (int i = 0; i < kNumStates; ++i) {
      for (int j = 0; j <= i; ++j) {
        // The scale of an entry is that of its variances, not its own: a covariance may vanish.
        const double difference = P(i, j) - other(i, j);
        if (!(difference * difference <= kStationary * kStationary * P(i, i) * P(j, j))) {
          return false;
        }
      }
    }
    return true;
  }

  static Covariance Start(const NoiseModel& model, const NoiseDynamics& dynamics) {
    Covariance P = Covariance::Zero();
    if constexpr (kHasV) {
      P(kW, kW) = dynamics.var_w();
      P(kV, kW) = dynamics.cov_wv();
      P(kV, kV) = dynamics.var_v();
    }
    const auto square = [](double x) { return x * x; };
    if constexpr (kHasC) P(kC, kC) = square(model.velocity.coloured.std);
    if constexpr (kHasCx) P(kCx, kCx) = square(model.displacement.coloured.std);
    return P;
  }

  // P <- F P F' + Q.
  static void Predict(const NoiseTransition& t, Covariance* covariance) {
    Covariance& P = *covariance;
    if constexpr (kHasX) {
      // Row x of F P.
      const double xw = P(kX, kW) + t.x_from_v * P(kV, kW) + t.x_from_w * P(kW, kW);
      const double xv = P(kX, kV) + t.x_from_v * P(kV, kV) + t.x_from_w * P(kV, kW);
      const double xx = P(kX, kX) + t.x_from_v * P(kX, kV) + t.x_from_w * P(kX, kW);
      P(kX, kX) = xx + t.x_from_v * xv + t.x_from_w * xw + t.q_xx;
      P(kX, kV) = t.v_from_v * xv + t.v_from_w * xw + t.q_vx;
      P(kX, kW) = t.w_from_w * xw + t.q_wx;
    }
    if constexpr (kHasV) {
      const double vw = t.v_from_v * P(kV, kW) + t.v_from_w * P(kW, kW);
      const double vv = t.v_from_v * P(kV, kV) + t.v_from_w * P(kV, kW);
      P(kV, kV) = t.v_from_v * vv + t.v_from_w * vw + t.q_vv;
      P(kV, kW) = t.w_from_w * vw + t.q_wv;
      P(kW, kW) = t.w_from_w * t.w_from_w * P(kW, kW) + t.q_ww;
    }
    const auto with_coloured = [&](int c, double decay) {
      if constexpr (kHasX) {
        P(c, kX) = decay * (P(c, kX) + t.x_from_v * P(c, kV) + t.x_from_w * P(c, kW));
      }
      if constexpr (kHasV) {
        P(c, kV) = decay * (t.v_from_v * P(c, kV) + t.v_from_w * P(c, kW));
        P(c, kW) *= decay * t.w_from_w;
      }
    };
    if constexpr (kHasC) {
      with_coloured(kC, t.velocity_c);
      P(kC, kC) = t.velocity_c * t.velocity_c * P(kC, kC) + t.q_velocity_c;
    }
    if constexpr (kHasCx) {
      with_coloured(kCx, t.displacement_c);
      if constexpr (kHasC) P(kCx, kC) *= t.displacement_c * t.velocity_c;
      P(kCx, kCx) = t.displacement_c * t.displacement_c * P(kCx, kCx) + t.q_displacement_c;
    }
  }

  // P <- P less what one sample says; fills the gain of `step` and returns the variance of its
  // innovation.
  static double Update(double white_variance, Covariance* covariance, WhiteningStep* step) {
    Covariance& P = *covariance;
    std::array<double, kNumStates> seen{};
    ForSeen(step->channel, [&](int k) {
      for (int i = 0; i < kNumStates; ++i) seen[i] += i < k ? P(k, i) : P(i, k);
    });
    double variance = white_variance;
    ForSeen(step->channel, [&](int k) { variance += seen[k]; });
    CHECK(variance > 0.0) << "A sample without a variance of its own: " << variance << ".";
    step->inverse_std = 1.0 / std::sqrt(variance);
    for (int i = 0; i < kNumStates; ++i) step->gain[i] = seen[i] *= step->inverse_std;
    for (int i = 0; i < kNumStates; ++i) {
      for (int j = 0; j <= i; ++j) P(i, j) -= seen[i] * seen[j];
    }
    return variance;
  }
};

}  // namespace fathom
