// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "true_motion.h"

#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>

namespace fathom {
namespace {

// Force as a function of time, displacement and speed; called every 1 / rate.
using Controller = std::function<double(double t, double x)>;

TrueMotion Integrate(const UncoupledModel<double>& m,
                     const CameraExperiment& experiment,
                     double v0,
                     const Controller& controller) {
  TrueMotion motion;
  // A force that the command does not show; a generator of its own leaves the other draws alone.
  std::mt19937 pushes(experiment.seed + 7919);
  std::normal_distribution<double> normal;
  const double decay = std::exp(-kTrueStep / 2.0);
  double push = 0.0;
  double x = 0.0, v = v0;
  const int per_command = static_cast<int>(std::lround(1.0 / (experiment.rate * kTrueStep)));
  const int num_steps = static_cast<int>(std::lround((experiment.duration + 1.0) / kTrueStep));
  double tau = 0.0;
  for (int i = 0; i <= num_steps; ++i) {
    const double t = i * kTrueStep;
    if (i % per_command == 0) {
      tau = controller(t, x);
      motion.command.time.push_back(t);
      motion.command.value.push_back(tau);
    }
    if (experiment.disturbance > 0.0) {
      push =
          decay * push + std::sqrt(1.0 - decay * decay) * experiment.disturbance * normal(pushes);
    }
    const auto a = [&](double speed) {
      return (tau + push - m.quadratic_damping * speed * std::abs(speed) -
              m.linear_damping * speed - m.buoyancy) /
             m.inertia;
    };
    motion.x.push_back(x);
    motion.v.push_back(v);
    motion.a.push_back(a(v));
    const double h = kTrueStep;
    const double k1 = a(v), k2 = a(v + 0.5 * h * k1), k3 = a(v + 0.5 * h * k2), k4 = a(v + h * k3);
    x += h * (v + h / 6.0 * (k1 + k2 + k3));
    v += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  }
  return motion;
}

// Eight lines between 0.1 and 0.9 rad/s.
struct Multisine {
  std::array<double, 8> frequency, phase;
  double amplitude;  // of each

  Multisine(double each, std::mt19937* generator) : amplitude(each) {
    std::uniform_real_distribution<double> any(0.0, 2.0 * std::numbers::pi);
    for (int i = 0; i < 8; ++i) {
      frequency[i] = 0.1 + 0.8 * i / 7.0;
      phase[i] = any(*generator);
    }
  }
  // Derivative `order` at `t`.
  double At(double t, int order) const {
    double sum = 0.0;
    for (int i = 0; i < 8; ++i) {
      sum += amplitude * std::pow(frequency[i], order) *
             std::sin(frequency[i] * t + phase[i] + order * 0.5 * std::numbers::pi);
    }
    return sum;
  }
};

// 96 lines of normal amplitudes, evenly over the band.
std::vector<double> BandPath(size_t n, std::mt19937* generator) {
  constexpr int kLines = 96;
  constexpr double kLow = 0.01, kHigh = 0.25;  // [Hz]
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> any(0.0, 1.0);
  std::vector<double> path(n, 0.0);
  for (int line = 0; line < kLines; ++line) {
    const double frequency =
        2.0 * std::numbers::pi * (kLow + (kHigh - kLow) * (line + any(*generator)) / kLines);
    const std::complex<double> turn = std::polar(1.0, frequency * kTrueStep);
    std::complex<double> at(normal(*generator), normal(*generator));
    at /= std::sqrt(kLines);
    for (size_t i = 0; i < n; ++i, at *= turn) path[i] += at.real();
  }
  return path;
}

std::vector<double> CyclePath(size_t n, std::mt19937* generator) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> any(0.0, 1.0);
  const double period = 6.0 + 8.0 * any(*generator);  // [s]
  double phase = any(*generator);                     // in periods
  std::vector<double> path(n);
  for (double& value : path) {
    value = std::sqrt(3.0) * (4.0 * std::abs(phase - std::floor(phase) - 0.5) - 1.0);
    phase += kTrueStep / period + 0.03 * std::sqrt(kTrueStep) * normal(*generator);
  }
  return path;
}

std::vector<double> StepPath(size_t n, std::mt19937* generator) {
  std::normal_distribution<double> normal;
  std::exponential_distribution<double> wait(1.0 / 20.0);  // [s]
  std::vector<double> level(n);
  double next = 0.0, now = 0.0;
  for (size_t i = 0; i < n; ++i) {
    const double t = static_cast<double>(i) * kTrueStep;
    if (t >= next) {
      now = normal(*generator);
      next = t + wait(*generator);
    }
    level[i] = now;
  }
  return Swing(level, 1.5, 0.9);
}

}  // namespace

std::vector<double> Swing(const std::vector<double>& push, double frequency, double ratio) {
  std::vector<double> path;
  path.reserve(push.size());
  double y = push.front(), rate = 0.0;
  for (const double to : push) {
    path.push_back(y);
    rate += kTrueStep * (frequency * frequency * (to - y) - 2.0 * ratio * frequency * rate);
    y += kTrueStep * rate;
  }
  return path;
}

TrueMotion Move(const CameraExperiment& experiment,
                const UncoupledModel<double>& m,
                std::mt19937* generator) {
  const double dt = 1.0 / experiment.rate;
  if (experiment.vehicle) {
    const Multisine x(0.15, generator);
    return Integrate(m, experiment, x.At(0.0, 1), [&](double t, double) {
      const double v = x.At(t, 1);
      return m.inertia * x.At(t, 2) + m.quadratic_damping * v * std::abs(v) + m.linear_damping * v +
             m.buoyancy;
    });
  }
  if (experiment.dof == Dof::kSurge) {  // open loop, trimmed by the buoyancy
    if (experiment.input == InputKind::kSine) {
      return Integrate(m, experiment, 0.0, [&](double t, double) {
        return m.buoyancy + 52.9 * std::cos(0.3 * t);
      });
    }
    if (experiment.input == InputKind::kSteps) {
      return Integrate(m, experiment, 0.0, [&](double t, double) {
        const int level = static_cast<int>(t / 7.0) % 4;
        return m.buoyancy + (level == 0 || level == 3 ? 20.0 : -20.0);
      });
    }
    const Multisine x(0.15, generator);
    return Integrate(m, experiment, x.At(0.0, 1), [&](double t, double) {
      const double v = x.At(t, 1);
      return m.inertia * x.At(t, 2) + m.quadratic_damping * v * std::abs(v) + m.linear_damping * v +
             m.buoyancy;
    });
  }
  // Closed loop: PID, as in data/experiments/table1.yaml.
  const bool heave = experiment.dof == Dof::kHeave;
  const double kp = heave ? 3000.0 : 600.0, ki = heave ? 300.0 : 60.0, kd = heave ? 2500.0 : 500.0;
  const double limit = heave ? 800.0 : 150.0;
  const Multisine lines(heave ? 0.15 : 0.05, generator);
  const auto setpoint = [&](double t) {
    if (experiment.input == InputKind::kSine) return (heave ? 1.0 : 0.3) * std::sin(0.3 * t);
    if (experiment.input == InputKind::kMultisine) return lines.At(t, 0) - lines.At(0.0, 0);
    const double level = heave ? 0.4 : 0.25;
    return static_cast<int>(t / 15.0) % 2 == 0 ? level : -level;
  };
  double integral = 0.0, last = 0.0;
  bool is_first = true;
  return Integrate(m, experiment, 0.0, [&](double t, double x) {
    const double error = setpoint(t) - x;
    const double slope = is_first ? 0.0 : (error - last) / dt;
    is_first = false;
    integral += error * dt;
    last = error;
    return std::clamp(kp * error + ki * integral + kd * slope, -limit, limit);
  });
}

std::vector<double> Wander(WanderKind kind, size_t n, std::mt19937* generator) {
  std::normal_distribution<double> normal;
  std::vector<double> path(n, 0.0);
  if (kind == WanderKind::kNone) return path;
  if (kind == WanderKind::kSinusoids) {
    std::uniform_real_distribution<double> any(0.0, 2.0 * std::numbers::pi);
    for (int line = 0; line < 12; ++line) {
      const double frequency = 0.03 * std::pow(1.3, line), phase = any(*generator);
      for (size_t i = 0; i < n; ++i) {
        path[i] += std::sqrt(2.0 / 12.0) *
                   std::sin(frequency * static_cast<double>(i) * kTrueStep + phase);
      }
    }
    return path;
  }
  if (kind == WanderKind::kBand) return BandPath(n, generator);
  if (kind == WanderKind::kCycle) return CyclePath(n, generator);
  if (kind == WanderKind::kSteps) return StepPath(n, generator);
  const double slow = 3.0, quick = kind == WanderKind::kRough ? 0.0 : 0.5;  // time constants [s]
  const double decay = std::exp(-kTrueStep / slow);
  double u = normal(*generator), y = u;
  // Of u through the lag: variance slow / (slow + quick).
  const double scale = std::sqrt((slow + quick) / slow);
  for (size_t i = 0; i < n; ++i) {
    path[i] = scale * y;
    u = decay * u + std::sqrt(1.0 - decay * decay) * normal(*generator);
    y = quick > 0.0 ? y + (u - y) * (1.0 - std::exp(-kTrueStep / quick)) : u;
  }
  return path;
}

TrueState StateAt(const TrueMotion& motion, size_t i, double s) {
  const double h = kTrueStep;
  const auto& [x, v, a, command] = motion;
  const double s2 = s * s, s3 = s2 * s;
  return {(2 * s3 - 3 * s2 + 1) * x[i] + (s3 - 2 * s2 + s) * h * v[i] +
              (3 * s2 - 2 * s3) * x[i + 1] + (s3 - s2) * h * v[i + 1],
          v[i] + s * (v[i + 1] - v[i])};
}

}  // namespace fathom
