// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/planning/experiment_plan.h"
#include "fathom/planning/plan_limits.h"
#include "fathom/signal/segment.h"
#include "fathom/vehicle/fitted_model.h"

#include <cstdint>
#include <vector>

namespace fathom {

// A vehicle drawn about FlatFish's surge, in a tank.
struct TankVehicle {
  UncoupledModel<double> truth;
  PlanLimits limits;  // the same for all
};
TankVehicle DrawTankVehicle(std::uint64_t seed);

// What a vehicle truly does under a command: by Heun's rule in steps of 10 ms, which is no code of
// Fathom's. Velocities and displacements at 10 Hz from t = 0 on.
struct TrueRun {
  std::vector<double> time, velocity, displacement;
};
TrueRun RunTruth(const UncoupledModel<double>& truth, const HeldCommand& command, double duration);

bool KeepsTankLimits(const TrueRun& run, const PlanLimits& limits);

inline constexpr double kTankNoise = 0.01;  // of the velocities, white [m/s]

// The log of a run with noise.
Segment MeasuredRun(const TrueRun& run,
                    const HeldCommand& command,
                    std::uint64_t seed,
                    double correlation = 0.0);

// FitOutputError() of a log, as a model file has it; inertia NaN where it is not usable.
FittedModel FitTankLog(const Segment& log);

// The sine of the paper's Table I over 120 s, as great as the truth allows.
HeldCommand LargestSine(const TankVehicle& vehicle, double duration);

// Steps of random height and length, as a person would draw them; made smaller until the truth
// keeps the limits.
HeldCommand RandomSteps(const TankVehicle& vehicle, double duration, std::uint64_t seed);

// Twelve lines from 0.08 to 1.6 rad/s, with random phases; as great as the truth allows.
HeldCommand RandomMultisine(const TankVehicle& vehicle, double duration, std::uint64_t seed);

// Standard deviation of each parameter in shares of its size, of the buoyancy in shares of the
// greatest force.
std::vector<double> RelativeStds(const FittedModel& fitted, const TankVehicle& vehicle);

// The plan by what was learned from a sine.
ExperimentPlan PlanInTank(const TankVehicle& vehicle,
                          const FittedModel& so_far,
                          double duration,
                          double effort = 1.0);

}  // namespace fathom
