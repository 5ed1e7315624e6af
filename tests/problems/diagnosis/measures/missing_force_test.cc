// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/measures/missing_force.h"

#include "fathom/diagnosis/fit/fit_with_noise.h"
#include "fathom/vehicle/effects/catalogue.h"

#include <cmath>
#include <vector>

#include "surge_run.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

constexpr double kJump = 12.0;      // [N]
constexpr double kJumpTime = 70.0;  // [s]

struct MadeForce {
  std::unique_ptr<TrainingData> data;
  StructureFit baseline, extended;
};

// A step hidden in a run; the baseline fitted without it, the extended model with it.
MadeForce WithAStep(std::uint64_t seed) {
  SurgeRun run;
  run.input = Multisine(40.0);
  run.effects = "buoyancy_step:jump=12:time=70";
  const std::vector<Log> logs = {LogOf(run, seed)};
  MadeForce made;
  made.data = std::make_unique<TrainingData>(MeasuredSegmentsOf(logs, Dof::kSurge).all);
  const std::vector<InitialState> start = {made.data->segments()[0].initial};
  made.baseline = FitBaseline(*made.data, {kSurgeTruth, {}}, start);
  made.extended =
      FitStructureAndNoise(*made.data,
                           {kSurgeTruth, {{FindEffect("buoyancy_step"), {}, {kJump, kJumpTime}}}},
                           start,
                           FirstNoise(*made.data, made.baseline));
  return made;
}

// What the baseline misses of the true vehicle's force, on the true vehicle's way: what it would
// take for the baseline to accelerate as the truth does.
std::vector<double> TrueMissingForce(const MadeForce& made, const std::vector<double>& time) {
  const MeasuredSegment& segment = made.data->segments()[0];
  OutputStamps stamps;
  stamps.start = 0.0;
  stamps.velocity = time;
  EffectOutputs truth;
  const ExtendedModel model = {kSurgeTruth,
                               {{FindEffect("buoyancy_step"), {}, {kJump, kJumpTime}}}};
  EXPECT_TRUE(EffectSimulation(segment.inputs.get(), stamps).Run(model, {0.0, 0.0}, &truth));
  const UncoupledModel<double>& baseline = made.baseline.model.baseline;
  std::vector<double> force;
  for (size_t i = 0; i < time.size(); ++i) {
    const double v = truth.velocity[i], tau = segment.inputs->command.At(time[i]);
    const double step = time[i] > kJumpTime ? kJump : 0.0;
    const double acceleration = kSurgeTruth.Acceleration(v, tau - step);
    force.push_back(baseline.inertia * (acceleration - baseline.Acceleration(v, tau)));
  }
  return force;
}

MissingForce MissingForceOf(const MadeForce& made) {
  return FindMissingForce(
      *made.data, StartedFrom(made.baseline), StartedFrom(made.extended), made.extended.noise, {});
}

TEST(MissingForce, HoldsTheTrueForceInItsBand) {
  int held = 0, held_by_half = 0, n = 0;
  for (int seed = 0; seed < 8; ++seed) {
    const MadeForce made = WithAStep(seed);
    const MissingForce missing = MissingForceOf(made);
    const std::vector<double> truth = TrueMissingForce(made, missing.time);
    ASSERT_EQ(truth.size(), missing.mean.size());
    for (size_t i = 0; i < truth.size(); ++i) {
      // A force that wanders with a time of 1.5 s cannot follow a jump at once.
      if (std::abs(missing.time[i] - kJumpTime) < 1.0) continue;
      ++n;
      const double miss = std::abs(truth[i] - missing.mean[i]);
      held += miss < 1.96 * missing.std[i];
      held_by_half += miss < 0.98 * missing.std[i];
    }
  }
  RecordProperty("share_in_band", std::to_string(static_cast<double>(held) / n));
  // At least 95 %, less the chance of 8 runs of 120 s: neighbours within 1.5 s go together, which
  // leaves 640 independent ones, a standard deviation of 0.9 %.
  EXPECT_GE(held, n * (0.95 - 3.0 * 0.009));
  // No band of arbitrary width: what is half as wide does not hold all.
  EXPECT_LT(held_by_half, n * 0.99);
}

// Before and after the jump it is a step of the true size, and the extended model accounts for it.
TEST(MissingForce, ShowsTheStepAndWhatExplainsIt) {
  const MadeForce made = WithAStep(1);
  const MissingForce missing = MissingForceOf(made);
  const auto change = [&](const std::vector<double>& force) {
    double before = 0.0, after = 0.0, n_before = 0.0, n_after = 0.0;
    for (size_t i = 0; i < force.size(); ++i) {
      const double t = missing.time[i];
      if (t > 40.0 && t < 68.0) before += force[i], n_before += 1.0;
      if (t > 72.0 && t < 100.0) after += force[i], n_after += 1.0;
    }
    return after / n_after - before / n_before;
  };
  const std::vector<double> truth = TrueMissingForce(made, missing.time);
  // A force that is taken to wander about zero is shrunk towards it, more so the weaker it shows.
  EXPECT_LT(change(missing.mean) / change(truth), 1.1);
  EXPECT_GT(change(missing.mean) / change(truth), 0.7);
  // What explains it is smoothed in the same way; noise of 10 mm/s at 10 Hz is between them.
  EXPECT_NEAR(change(missing.explained), change(missing.mean), 0.1 * kJump);
  EXPECT_LT(change(truth), -0.5 * kJump);
  EXPECT_EQ(missing.command.size(), missing.time.size());
  EXPECT_EQ(missing.velocity.size(), missing.time.size());
}

}  // namespace
}  // namespace fathom
