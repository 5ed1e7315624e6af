// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tank_trial.h"

#include "fathom/base/random_stream.h"
#include "fathom/output_error/output_error.h"
#include "fathom/planning/plan_experiment.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace fathom {
namespace {

constexpr double kRate = 10.0;  // of the velocities and commands [Hz]

// A command of this shape, offset by what holds the vehicle, at the greatest of 40 sizes that the
// truth allows.
HeldCommand LargestOf(const TankVehicle& vehicle,
                      double duration,
                      double hold,
                      const std::function<double(double)>& shape) {
  HeldCommand command;
  for (int share = 40; share >= 1; --share) {
    command = {};
    const double size = (vehicle.limits.force - std::abs(vehicle.truth.buoyancy)) * share / 40.0;
    for (int i = 0; i * hold < duration - 1e-9; ++i) {
      command.time.push_back(i * hold);
      command.value.push_back(vehicle.truth.buoyancy + size * shape(i * hold));
    }
    if (KeepsTankLimits(RunTruth(vehicle.truth, command, duration), vehicle.limits)) break;
  }
  return command;
}

}  // namespace

TankVehicle DrawTankVehicle(std::uint64_t seed) {
  RandomStream random(seed, "tank.vehicle");
  const auto about = [&](double value) { return value * std::exp(0.4 * random.Normal()); };
  TankVehicle vehicle;
  vehicle.truth = {about(850.0), about(60.0), about(40.0), 1.5 * random.Normal()};
  vehicle.limits = {.force = 60.0, .speed = 0.6, .distance = {-3.0, 5.0}};
  return vehicle;
}

TrueRun RunTruth(const UncoupledModel<double>& truth, const HeldCommand& command, double duration) {
  const double h = 0.01;
  const int steps_per_sample = 10;
  TrueRun run;
  double v = 0.0, x = 0.0;
  const auto acceleration = [&](double speed, double force) {
    return (force - truth.quadratic_damping * speed * std::abs(speed) -
            truth.linear_damping * speed - truth.buoyancy) /
           truth.inertia;
  };
  std::size_t next = 0;
  double force = 0.0;
  const int num_steps = static_cast<int>(std::round(duration / h));
  for (int i = 0; i <= num_steps; ++i) {
    if (i % steps_per_sample == 0) {
      run.time.push_back(i / steps_per_sample / kRate);
      run.velocity.push_back(v);
      run.displacement.push_back(x);
    }
    while (next < command.time.size() && command.time[next] <= i * h + 1e-9) {
      force = command.value[next++];
    }
    const double a = acceleration(v, force);
    const double b = acceleration(v + h * a, force);
    x += h * v + 0.5 * h * h * a;
    v += 0.5 * h * (a + b);
  }
  return run;
}

bool KeepsTankLimits(const TrueRun& run, const PlanLimits& limits) {
  for (std::size_t i = 0; i < run.time.size(); ++i) {
    if (std::abs(run.velocity[i]) > limits.speed) return false;
    if (run.displacement[i] < limits.distance.low) return false;
    if (run.displacement[i] > limits.distance.high) return false;
  }
  return true;
}

Segment MeasuredRun(const TrueRun& run,
                    const HeldCommand& command,
                    std::uint64_t seed,
                    double correlation) {
  RandomStream random(seed, "tank.noise");
  Segment log;
  log.time = run.time;
  log.command = command;
  double error = random.Normal();
  for (const double velocity : run.velocity) {
    log.velocity.push_back(velocity + kTankNoise * error);
    error = correlation * error + std::sqrt(1.0 - correlation * correlation) * random.Normal();
  }
  return log;
}

FittedModel FitTankLog(const Segment& log) {
  OutputErrorOptions options;
  options.initial_guess = UncoupledModel<double>{800.0, 50.0, 50.0, 0.0};
  const OutputErrorSummary summary = FitOutputError({&log, 1}, options);
  FittedModel fitted;
  fitted.force_unit = "N";
  fitted.model = summary.model;
  if (!summary.IsUsable()) fitted.model.inertia = std::nan("");
  fitted.covariance = summary.covariance;
  fitted.residual_autoregression = summary.evidence.noise.coefficients;
  fitted.train.num_samples = static_cast<int>(log.time.size());
  fitted.train.duration = log.time.back() - log.time.front();
  // The mean size of a normal number of this deviation.
  fitted.train.mae = kTankNoise * std::sqrt(2.0 / std::numbers::pi);
  return fitted;
}

HeldCommand LargestSine(const TankVehicle& vehicle, double duration) {
  return LargestOf(vehicle, duration, 0.1, [](double t) { return std::sin(0.3 * t); });
}

HeldCommand RandomSteps(const TankVehicle& vehicle, double duration, std::uint64_t seed) {
  RandomStream random(seed, "tank.steps");
  std::vector<double> levels;
  while (static_cast<double>(levels.size()) < duration) {
    const double level = 2.0 * random.Uniform() - 1.0;
    const int hold = static_cast<int>(std::exp(random.Uniform() * std::log(20.0)));
    levels.insert(levels.end(), std::max(1, hold), level);
  }
  return LargestOf(vehicle, duration, 1.0, [&](double t) {
    return levels[static_cast<std::size_t>(std::round(t))];
  });
}

HeldCommand RandomMultisine(const TankVehicle& vehicle, double duration, std::uint64_t seed) {
  RandomStream random(seed, "tank.multisine");
  std::array<double, 12> phases{};
  for (double& phase : phases) phase = 2.0 * std::numbers::pi * random.Uniform();
  const auto sum = [&](double t) {
    double value = 0.0;
    for (std::size_t i = 0; i < phases.size(); ++i) {
      value += std::sin((0.08 + 1.52 * static_cast<double>(i) / 11.0) * t + phases[i]);
    }
    return value;
  };
  double peak = 0.0;
  for (double t = 0.0; t < duration; t += 0.1) peak = std::max(peak, std::abs(sum(t)));
  return LargestOf(vehicle, duration, 0.1, [&](double t) { return sum(t) / peak; });
}

std::vector<double> RelativeStds(const FittedModel& fitted, const TankVehicle& vehicle) {
  const ParameterVector truth = ToVector(vehicle.truth);
  std::vector<double> shares;
  for (int i = 0; i < kNumParameters; ++i) {
    const double size = i == kBuoyancy ? vehicle.limits.force : truth[i];
    shares.push_back(std::sqrt(fitted.covariance(i, i)) / size);
  }
  return shares;
}

ExperimentPlan PlanInTank(const TankVehicle& vehicle,
                          const FittedModel& so_far,
                          double duration,
                          double effort) {
  PlanRequest request;
  request.model = so_far;
  request.name = "sine.json";
  request.limits = vehicle.limits;
  request.duration = duration;
  request.effort = effort;
  return PlanExperiment(request);
}

}  // namespace fathom
