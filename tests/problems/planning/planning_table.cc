// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// The table of docs/plan.md: what planned experiments give, over drawn vehicles. Run by hand:
//
//   planning_table [vehicles] [correlation of the noise]

#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "tank_trial.h"
#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kDuration = 120.0;  // [s]

double WeakestOf(const TankVehicle& vehicle, const HeldCommand& command, double correlation) {
  const TrueRun run = RunTruth(vehicle.truth, command, kDuration);
  const FittedModel fitted = FitTankLog(MeasuredRun(run, command, 7, correlation));
  if (std::isnan(fitted.model.inertia)) return INFINITY;
  const std::vector<double> shares = RelativeStds(fitted, vehicle);
  return *std::max_element(shares.begin(), shares.end());
}

constexpr int kRepeats = 20;

// What fits of the planned experiment say, each time with other noise, over what was predicted:
// root mean squares of what they report, by parameter, and of their true errors, of all.
struct Repeats {
  ParameterVector reported = ParameterVector::Zero();
  double errors = 0.0;
  int unusable = 0;
};

Repeats RepeatsOf(const TankVehicle& vehicle,
                  const ExperimentPlan& plan,
                  const TrueRun& run,
                  double correlation) {
  ParameterVector after;
  for (int p = 0; p < kNumParameters; ++p) after[p] = plan.parameters[p].after;
  ParameterVector variances = ParameterVector::Zero();
  double squares = 0.0;
  Repeats repeats;
  for (std::uint64_t i = 0; i < kRepeats; ++i) {
    const FittedModel fitted = FitTankLog(MeasuredRun(run, plan.command, 1000 + i, correlation));
    if (std::isnan(fitted.model.inertia)) {
      ++repeats.unusable;
      continue;
    }
    variances += fitted.covariance.diagonal().cwiseQuotient(after.cwiseAbs2());
    squares +=
        (ToVector(fitted.model) - ToVector(vehicle.truth)).cwiseQuotient(after).squaredNorm();
  }
  const double num_usable = kRepeats - repeats.unusable;
  repeats.reported = (variances / num_usable).cwiseSqrt();
  repeats.errors = std::sqrt(squares / (num_usable * kNumParameters));
  return repeats;
}

void TryVehicle(std::uint64_t seed, double correlation) {
  const TankVehicle vehicle = DrawTankVehicle(seed);
  const HeldCommand sine = LargestSine(vehicle, kDuration);
  const TrueRun sine_run = RunTruth(vehicle.truth, sine, kDuration);
  const FittedModel so_far = FitTankLog(MeasuredRun(sine_run, sine, seed, correlation));
  const auto start = std::chrono::steady_clock::now();
  const ExperimentPlan plan = PlanInTank(vehicle, so_far, kDuration);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (!plan.IsUsable()) {
    fmt::print("{:3} no plan: {}\n", seed, plan.message);
    return;
  }
  const TrueRun run = RunTruth(vehicle.truth, plan.command, kDuration);
  const FittedModel fitted = FitTankLog(MeasuredRun(run, plan.command, seed + 100, correlation));
  const std::vector<double> shares = RelativeStds(fitted, vehicle);
  const double planned = *std::max_element(shares.begin(), shares.end());
  double steps = INFINITY, multisines = INFINITY;
  for (std::uint64_t i = 0; i < 40; ++i) {
    steps = std::min(steps, WeakestOf(vehicle, RandomSteps(vehicle, kDuration, i), correlation));
    if (i >= 10) continue;
    multisines = std::min(multisines,
                          WeakestOf(vehicle, RandomMultisine(vehicle, kDuration, i), correlation));
  }
  fmt::print(
      "{:3} m {:6.1f} dq {:5.1f} dl {:5.1f} b {:5.2f} | weakest {:7.4f} /steps {:5.2f} "
      "/multi {:5.2f} /sine {:5.2f} | fits/predicted",
      seed,
      vehicle.truth.inertia,
      vehicle.truth.quadratic_damping,
      vehicle.truth.linear_damping,
      vehicle.truth.buoyancy,
      planned,
      planned / steps,
      planned / multisines,
      planned / WeakestOf(vehicle, sine, correlation));
  const Repeats repeats = RepeatsOf(vehicle, plan, run, correlation);
  for (const double ratio : repeats.reported) fmt::print(" {:4.2f}", ratio);
  fmt::print(
      " errors {:4.2f} unusable {} | {} breaking {:.3f} | blocks {} | {:.1f} s\n",
      repeats.errors,
      repeats.unusable,
      KeepsTankLimits(RunTruth(vehicle.truth, plan.command, kDuration + 10.0), vehicle.limits)
          ? "kept"
          : "BROKEN",
      plan.share_breaking,
      plan.blocks.size(),
      seconds);
  std::fflush(stdout);
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) {
  const int num_vehicles = argc > 1 ? std::atoi(argv[1]) : 20;
  const double correlation = argc > 2 ? std::atof(argv[2]) : 0.0;
  const int first = argc > 3 ? std::atoi(argv[3]) : 1;
  for (int seed = first; seed <= num_vehicles; ++seed) {
    fathom::TryVehicle(static_cast<std::uint64_t>(seed), correlation);
  }
  return 0;
}
