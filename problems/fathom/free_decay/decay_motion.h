// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// The rates of a free decay: each force by the inertia.
//
//   dv/dt = -(a v + b v|v| + c x + d),   dx/dt = v      docs/free_decay.md (1)
//
//   a  linear damping      [1/s], at least 0
//   b  quadratic damping   [1/m] or [1/rad], at least 0
//   c  stiffness           [1/s^2], at least 0; x is the displacement from where it vanishes
//   d  constant force      [m/s^2] or [rad/s^2]
enum DecayRate { kLinearRate, kQuadraticRate, kStiffnessRate, kConstantRate };
inline constexpr int kNumDecayRates = 4;
using DecayRates = std::array<double, kNumDecayRates>;

// Columns of the sensitivities: the rates, then the velocity and the displacement at the start.
inline constexpr int kStartVelocity = 4, kStartDisplacement = 5, kNumDecaySensitivities = 6;
using DecayGradient = Eigen::Matrix<double, kNumDecaySensitivities, 1>;

struct DecaySample {
  double velocity = 0.0, displacement = 0.0;
  DecayGradient velocity_gradient = DecayGradient::Zero();
  DecayGradient displacement_gradient = DecayGradient::Zero();
};

// The motion at the stamps, which rise, from a start at the first of them, by Runge and Kutta's
// fourth order in steps that are short for the rates. Empty if it does not stay finite.
std::vector<DecaySample> SimulateDecay(const DecayRates& rates,
                                       double velocity,
                                       double displacement,
                                       std::span<const double> time);

}  // namespace fathom
