// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/signal/signals.h"
#include "fathom/vehicle/uncoupled_model.h"

#include <cmath>
#include <functional>
#include <random>

namespace fathom {

// A 1-DOF run integrated by a code of its own: classical Runge-Kutta, 10 steps a sample, the force
// held over each sample. `force` gets time, position and velocity: open or closed loop.
struct Experiment {
  UncoupledModel<double> truth;
  std::function<double(double t, double x, double v)> force;
  double duration = 300.0;  // [s]
  double rate = 10.0;       // [Hz]
  double noise = 0.01;      // sd of the measured velocity [m/s]
};

inline Segment RunOf(const Experiment& experiment, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  const auto& m = experiment.truth;
  Segment segment;
  double x = 0.0, v = 0.0;
  const double h = 0.1 / experiment.rate;
  for (int i = 0; i <= experiment.duration * experiment.rate; ++i) {
    const double t = i / experiment.rate;
    const double tau = experiment.force(t, x, v);
    segment.time.push_back(t);
    segment.velocity.push_back(v + experiment.noise * normal(generator));
    segment.command.time.push_back(t);
    segment.command.value.push_back(tau);
    const auto a = [&](double w) {
      return (tau - m.quadratic_damping * w * std::abs(w) - m.linear_damping * w - m.buoyancy) /
             m.inertia;
    };
    for (int k = 0; k < 10; ++k) {
      const double k1 = a(v), k2 = a(v + 0.5 * h * k1), k3 = a(v + 0.5 * h * k2),
                   k4 = a(v + h * k3);
      x += h * (v + h / 6.0 * (k1 + k2 + k3));
      v += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    }
  }
  return segment;
}

// The paper's Table I with the vehicle of Table II.
inline Experiment FlatFishSurge() {
  return {.truth = {851.05, 8.62, 39.57, -0.81},
          .force = [](double t, double, double) { return 52.9 * std::sin(0.3 * t); }};
}

// Position control of a sine of `amplitude` at 0.3 rad/s: critically damped at 0.8 rad/s.
inline Experiment ClosedLoop(const UncoupledModel<double>& truth, double amplitude) {
  const double m = truth.inertia;
  return {.truth = truth, .force = [=](double t, double x, double v) {
            const double w = 0.3, k = 0.8;
            return m * (k * k * (amplitude * std::sin(w * t) - x) +
                        2.0 * k * (amplitude * w * std::cos(w * t) - v));
          }};
}

inline Experiment FlatFishHeave() { return ClosedLoop({1511.53, 1911.21, 31.4, -12.42}, 1.0); }

inline Experiment FlatFishYaw() { return ClosedLoop({301.6, 279.39, 26.92, -0.0909}, 0.3); }

}  // namespace fathom
