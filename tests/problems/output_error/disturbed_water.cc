// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "disturbed_water.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

namespace fathom {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kLowest = 0.01, kHighest = 0.25;  // of the wander [Hz]
constexpr double kStep = 0.05;                     // of a realisation [s]
constexpr double kGustsApart = 4.0;                // mean, in lengths of a gust

// Values on a grid from 0, in line between them.
std::function<double(double)> Interpolated(std::vector<double> values) {
  const auto shared = std::make_shared<const std::vector<double>>(std::move(values));
  return [shared](double t) {
    const double place = std::clamp(t / kStep, 0.0, static_cast<double>(shared->size() - 2));
    const auto k = static_cast<std::size_t>(place);
    return (*shared)[k] + (place - static_cast<double>(k)) * ((*shared)[k + 1] - (*shared)[k]);
  };
}

std::vector<double> Turbulence(const WaterForce& force, std::size_t n, std::mt19937& generator) {
  std::normal_distribution<double> normal;
  const double kept = std::exp(-kStep / force.time);
  std::vector<double> values = {force.std * normal(generator)};
  while (values.size() < n) {
    values.push_back(kept * values.back() +
                     force.std * std::sqrt(1.0 - kept * kept) * normal(generator));
  }
  return values;
}

// Tones at frequencies drawn from the band.
std::vector<double> Wander(const WaterForce& force, std::size_t n, std::mt19937& generator) {
  constexpr int kNumTones = 200;
  std::uniform_real_distribution<double> frequency(kLowest, kHighest), phase(0.0, 2.0 * kPi);
  std::vector<double> values(n, 0.0);
  const double amplitude = force.std * std::sqrt(2.0 / kNumTones);
  for (int k = 0; k < kNumTones; ++k) {
    const double omega = 2.0 * kPi * frequency(generator), shift = phase(generator);
    for (std::size_t i = 0; i < n; ++i) {
      values[i] += amplitude * std::sin(omega * kStep * static_cast<double>(i) + shift);
    }
  }
  return values;
}

std::vector<double> Steps(const WaterForce& force, std::size_t n, std::mt19937& generator) {
  std::normal_distribution<double> level(0.0, force.std);
  std::exponential_distribution<double> wait(1.0 / force.time);
  std::vector<double> values;
  double left = wait(generator), now = level(generator);
  while (values.size() < n) {
    for (; left <= 0.0; left += wait(generator)) now = level(generator);
    values.push_back(now);
    left -= kStep;
  }
  return values;
}

std::vector<double> Gusts(const WaterForce& force, std::size_t n, std::mt19937& generator) {
  std::exponential_distribution<double> wait(1.0 / (kGustsApart * force.time));
  std::normal_distribution<double> strength(0.0, force.std * std::sqrt(2.0 * kGustsApart));
  std::vector<double> values(n, 0.0);
  const double end = kStep * static_cast<double>(n);
  for (double start = wait(generator) - force.time; start < end; start += wait(generator)) {
    const double peak = strength(generator);
    const auto first = static_cast<std::size_t>(std::max(0.0, std::ceil(start / kStep)));
    for (std::size_t i = first; i < n; ++i) {
      const double since = kStep * static_cast<double>(i) - start;
      if (since > force.time) break;
      values[i] += peak * std::sin(kPi * since / force.time);
    }
  }
  return values;
}

}  // namespace

double WaterForce::Covariance(double lag) const {
  const double s = std::abs(lag), variance = std * std;
  switch (kind) {
    case Kind::kStill:
      return 0.0;
    case Kind::kTurbulence:
    case Kind::kSteps:
      return variance * std::exp(-s / time);
    case Kind::kWander:
      if (s == 0.0) return variance;
      return variance * (std::sin(2.0 * kPi * kHighest * s) - std::sin(2.0 * kPi * kLowest * s)) /
             (2.0 * kPi * (kHighest - kLowest) * s);
    case Kind::kGusts: {
      // The overlap of two half sines `s` apart, over that of one with itself.
      const double u = s / time;
      if (u >= 1.0) return 0.0;
      return variance * ((1.0 - u) * std::cos(kPi * u) + std::sin(kPi * u) / kPi);
    }
  }
  return 0.0;
}

std::function<double(double)> WaterForce::Draw(double duration, std::mt19937& generator) const {
  const auto n = static_cast<std::size_t>(std::ceil(duration / kStep)) + 2;
  switch (kind) {
    case Kind::kStill:
      break;
    case Kind::kTurbulence:
      return Interpolated(Turbulence(*this, n, generator));
    case Kind::kWander:
      return Interpolated(Wander(*this, n, generator));
    case Kind::kSteps:
      return Interpolated(Steps(*this, n, generator));
    case Kind::kGusts:
      return Interpolated(Gusts(*this, n, generator));
  }
  return {};
}

}  // namespace fathom
