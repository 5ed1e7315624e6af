// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace fathom {

// Ornstein-Uhlenbeck noise: covariance std^2 exp(-|dt| / time), docs/residual_noise.md (2).
// A std of 0: there is none.
struct OrnsteinUhlenbeck {
  double std = 0.0;   // unit of the noise, at least 0
  double time = 1.0;  // correlation time [s], above 0

  bool IsPresent() const { return std > 0.0; }
};

// What a sensor adds to the truth: white noise plus coloured noise.
struct SensorNoise {
  double white_std = 0.0;      // unit of the channel, at least 0
  OrnsteinUhlenbeck coloured;  // unit of the channel
};

// The residual of a free-running simulation that misses nothing, along one DOF:
//
//   e_v(t) = v'(t) + sensor noise,   e_x(t) = x'(t) + sensor noise   docs/residual_noise.md (1)
//   dv'/dt = -a v' + w,   dx'/dt = v',   w Ornstein-Uhlenbeck        docs/residual_noise.md (3)
//
//   w   disturbance of the acceleration, mild turbulence  [m/s^2] or [rad/s^2]
//   v'  what it does to the velocity                      [m/s] or [rad/s]
//   x'  and to the displacement                           [m] or [rad]
//   a   damping rate of the vehicle about its motion      [1/s]
//
// v' and w are stationary from the start of a segment, at a usual speed; x' is 0 at its first
// sample.
struct NoiseModel {
  SensorNoise velocity;
  SensorNoise displacement;
  OrnsteinUhlenbeck disturbance;  // w
  double damping_rate = 0.1;      // a at a usual speed [1/s], above 0 where there is a disturbance

  // Stationary standard deviation of v' [m/s] or [rad/s].
  double DisturbedVelocityStd() const;
};

enum class NoiseChannel { kVelocity, kDisplacement };

// One measured value of the residual. Samples are ordered by segment, and by time within it; both
// channels may have a sample at the same time. Segments are independent of one another.
struct NoiseSample {
  double time = 0.0;  // [s]
  NoiseChannel channel = NoiseChannel::kVelocity;
  double variance_factor =
      1.0;  // on the white part, above 0: 4 for a mean of a quarter of the usual
  int segment = 0;

  // On the damping rate a since the sample before, above 0: a vehicle of quadratic damping at rest
  // is easily pushed about. Few values in all; each has its own table of transitions.
  double damping_factor = 1.0;
};

}  // namespace fathom
