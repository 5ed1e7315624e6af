// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/free_decay/decay_motion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fathom {
namespace {

DecaySample SlopeAt(const DecayRates& rates, const DecaySample& at) {
  const auto& [a, b, c, d] = rates;
  const double v = at.velocity, x = at.displacement, speed = std::abs(v);
  DecaySample slope;
  slope.velocity = -(a * v + b * v * speed + c * x + d);
  slope.displacement = v;
  slope.velocity_gradient =
      -(a + 2.0 * b * speed) * at.velocity_gradient - c * at.displacement_gradient;
  slope.velocity_gradient[kLinearRate] -= v;
  slope.velocity_gradient[kQuadraticRate] -= v * speed;
  slope.velocity_gradient[kStiffnessRate] -= x;
  slope.velocity_gradient[kConstantRate] -= 1.0;
  slope.displacement_gradient = at.velocity_gradient;
  return slope;
}

void AddTo(DecaySample* sum, double factor, const DecaySample& term) {
  sum->velocity += factor * term.velocity;
  sum->displacement += factor * term.displacement;
  sum->velocity_gradient += factor * term.velocity_gradient;
  sum->displacement_gradient += factor * term.displacement_gradient;
}

DecaySample Moved(DecaySample from, double h, const DecaySample& slope) {
  AddTo(&from, h, slope);
  return from;
}

void Step(const DecayRates& rates, double h, DecaySample* state) {
  const DecaySample k1 = SlopeAt(rates, *state);
  const DecaySample k2 = SlopeAt(rates, Moved(*state, h / 2.0, k1));
  const DecaySample k3 = SlopeAt(rates, Moved(*state, h / 2.0, k2));
  const DecaySample k4 = SlopeAt(rates, Moved(*state, h, k3));
  AddTo(state, h / 6.0, k1);
  AddTo(state, h / 3.0, k2);
  AddTo(state, h / 3.0, k3);
  AddTo(state, h / 6.0, k4);
}

}  // namespace

std::vector<DecaySample> SimulateDecay(const DecayRates& rates,
                                       double velocity,
                                       double displacement,
                                       std::span<const double> time) {
  // A step of a tenth of the shortest time constant is off by 1e-7 of the motion.
  constexpr double kLongestStep = 0.1, kMostSteps = 50.0;
  std::vector<DecaySample> samples;
  samples.reserve(time.size());
  DecaySample state;
  state.velocity = velocity;
  state.displacement = displacement;
  state.velocity_gradient[kStartVelocity] = 1.0;
  state.displacement_gradient[kStartDisplacement] = 1.0;
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (i > 0) {
      const double rate = std::abs(rates[kLinearRate]) +
                          2.0 * std::abs(rates[kQuadraticRate] * state.velocity) +
                          std::sqrt(std::abs(rates[kStiffnessRate]));
      const double span = time[i] - time[i - 1];
      const double steps = std::ceil(span * rate / kLongestStep);
      if (!(steps <= kMostSteps)) return {};
      const int num_steps = std::max(1, static_cast<int>(steps));
      for (int k = 0; k < num_steps; ++k) Step(rates, span / num_steps, &state);
    }
    if (!std::isfinite(state.velocity) || !std::isfinite(state.displacement) ||
        !state.velocity_gradient.allFinite() || !state.displacement_gradient.allFinite()) {
      return {};
    }
    samples.push_back(state);
  }
  return samples;
}

}  // namespace fathom
