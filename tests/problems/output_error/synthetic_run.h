// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/signal/signals.h"
#include "fathom/vehicle/uncoupled_model.h"

#include <cmath>
#include <functional>
#include <random>

namespace fathom {

// A run of a known model, integrated by a code of its own: classical Runge-Kutta, 8 steps a sample.
struct SyntheticRun {
  UncoupledModel<double> truth = {851.05, 60.0, 39.57, -0.81};
  std::function<double(double)> command;  // [N] at time t, held for one sample
  double duration = 300.0;                // [s]
  double rate = 10.0;                     // [Hz], of command and measurement
  double start = 0.0;                     // [s]
  double initial_velocity = 0.0;          // [m/s]
  double noise = 0.0;                     // sd of the measurement [m/s], and of the position [m]
  double noise_correlation = 0.0;         // of neighbouring samples

  // Force of the water that no command knows of [N], at time t; none: still.
  std::function<double(double)> disturbance = {};
};

// Four tones between 0.06 and 1.2 rad/s.
inline double Multisine(double t) {
  return 40.0 * std::sin(0.06 * t + 0.3) + 40.0 * std::sin(0.17 * t + 2.0) +
         40.0 * std::sin(0.45 * t + 4.1) + 40.0 * std::sin(1.2 * t + 5.0);
}

inline Segment Synthesize(const SyntheticRun& run, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  Segment segment;
  const auto& m = run.truth;
  const double h = 1.0 / (8.0 * run.rate);
  const double innovation =
      run.noise * std::sqrt(1.0 - run.noise_correlation * run.noise_correlation);
  double v = run.initial_velocity, x = 0.0, e = run.noise * normal(generator);
  for (int i = 0; i <= run.duration * run.rate; ++i) {
    const double t = run.start + i / run.rate;
    const double tau = run.command(t);
    segment.time.push_back(t);
    segment.command.time.push_back(t);
    segment.command.value.push_back(tau);
    segment.velocity.push_back(v + e);
    segment.position.push_back(x + run.noise * normal(generator));
    e = run.noise_correlation * e + innovation * normal(generator);
    double push = 0.0;
    const auto a = [&](double speed) {
      return (tau + push - m.quadratic_damping * speed * std::abs(speed) -
              m.linear_damping * speed - m.buoyancy) /
             m.inertia;
    };
    for (int k = 0; k < 8; ++k) {
      push = run.disturbance ? run.disturbance(t + (k + 0.5) * h) : 0.0;
      const double k1 = a(v), k2 = a(v + 0.5 * h * k1), k3 = a(v + 0.5 * h * k2),
                   k4 = a(v + h * k3);
      x += h * (v + h / 6.0 * (k1 + k2 + k3));
      v += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    }
  }
  return segment;
}

}  // namespace fathom
