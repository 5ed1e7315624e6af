// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/measures/limits.h"

#include "fathom/base/random_stream.h"
#include "fathom/diagnosis/data/measured_segments.h"
#include "fathom/diagnosis/fit/fit_with_noise.h"
#include "fathom/diagnosis/search/suspects.h"
#include "fathom/vehicle/effects/catalogue.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "side_by_side.h"
#include "surge_run.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

// The limits of one run, by label: of all suspects, or of `only` one. They do not depend on each
// other.
std::map<std::string, ExclusionLimit> LimitsIn(const Log& log, const std::string& only = "") {
  const MeasuredSegments segments = MeasuredSegmentsOf(std::span<const Log>(&log, 1), Dof::kSurge);
  const TrainingData data(segments.all, kSurgeTruth);
  const StructureFit fit =
      FitBaseline(data, {kSurgeTruth, {}}, std::vector{data.segments()[0].initial});
  std::vector<Suspect> suspects = SuspectsFor(segments, Dof::kSurge, EffectCatalogue());
  if (!only.empty()) {
    std::erase_if(suspects, [&](const Suspect& suspect) { return LabelOf(suspect) != only; });
  }
  std::map<std::string, ExclusionLimit> by_label;
  for (ExclusionLimit& limit : LimitsOf(data, fit, suspects)) by_label[limit.label] = limit;
  return by_label;
}

struct Small {
  const char* effect;  // as --effects
  const char* label;
  double truth;
};

// The log with white noise on its velocity.
Log WithNoise(Log log, double std, std::uint64_t seed) {
  RandomStream random(seed, "velocity");
  for (double& velocity : log.velocity->values.front()) velocity += std * random.Normal();
  return log;
}

// How many of so many runs with a small effect have it within its limits: all of one motion, each
// with a noise of its own.
int NumHeld(const Small& small, int num_runs) {
  SurgeRun run;
  run.input = Multisine(40.0);
  run.effects = small.effect;
  const double noise = std::exchange(run.velocity_noise, 0.0);
  const Log motion = LogOf(run, 1);
  std::vector<char> is_held(num_runs, 0);
  SideBySide(num_runs, 2, [&](std::size_t i) {
    const Log log = WithNoise(motion, noise, 100 + i);
    const ExclusionLimit limit = LimitsIn(log, small.label).at(small.label);
    is_held[i] = limit.is_told && limit.low <= small.truth && small.truth <= limit.high;
  });
  return static_cast<int>(std::count(is_held.begin(), is_held.end(), 1));
}

// Effects too small to be named lie within the limits in 95 % of runs. A share of 300 has a
// standard deviation of 1.3 %, one of all 0.5 %. Limits on what is slow are a little cautious, as
// the noise is (docs/residual_noise.md).
TEST(LimitsOf, HoldSmallEffectsAsOftenAsTheySay) {
  constexpr int kNumRuns = 300;
  const std::vector<Small> all = {
      {"coulomb_friction:force=0.3", "coulomb_friction", 0.3},
      {"thrust_dead_zone:width=0.3", "thrust_dead_zone", 0.3},
      {"thruster_lag:time_constant=0.03", "thruster_lag", 0.03},
      {"time_offset:offset=-0.02", "time_offset", -0.02},
      {"thrust_asymmetry:reverse_loss=0.01", "thrust_asymmetry", 0.01},
      {"position_stiffness:stiffness=0.01", "position_stiffness", 0.01}};
  int total = 0;
  for (const Small& small : all) {
    const int num_held = NumHeld(small, kNumRuns);
    EXPECT_NEAR(num_held, 0.95 * kNumRuns, 0.04 * kNumRuns) << small.effect;
    total += num_held;
  }
  const double share = total / (static_cast<double>(all.size()) * kNumRuns);
  EXPECT_GT(share, 0.93);
  EXPECT_LT(share, 0.97);
}

// Of an end that may be infinite, within a quarter turn.
double Bounded(double end) { return std::atan(end); }

// What the test above relies on: a limit is the same whether the others are asked for or not.
TEST(LimitsOf, DoNotDependOnEachOther) {
  SurgeRun run;
  run.input = Multisine(40.0);
  run.effects = "thrust_dead_zone:width=0.3";
  const Log log = LogOf(run, 7);
  const auto all = LimitsIn(log);
  ASSERT_GT(all.size(), 6u);
  for (const auto& [label, limit] : all) {
    const ExclusionLimit alone = LimitsIn(log, label).at(label);
    EXPECT_EQ(alone.is_told, limit.is_told) << label;
    EXPECT_NEAR(Bounded(alone.low), Bounded(limit.low), 1e-6) << label;
    EXPECT_NEAR(Bounded(alone.high), Bounded(limit.high), 1e-6) << label;
  }
}

// A saturation that the command never reaches changes nothing, so that none is excluded.
TEST(LimitsOf, ExcludeNoSaturationAboveTheLargestCommand) {
  SurgeRun run;
  run.input = Multisine(40.0);
  const Log log = LogOf(run, 1);
  const std::vector<double>* command = log.command->Find("tau_surge");
  const auto [least, most] = std::minmax_element(command->begin(), command->end());
  const ExclusionLimit limit = LimitsIn(log).at("thrust_saturation");
  EXPECT_TRUE(limit.is_told);
  EXPECT_LE(limit.low, std::max(-*least, *most));
  EXPECT_GT(limit.low, 0.5 * *most);
}

// A command of one level shows any thrust curve and any asymmetry as another scale.
TEST(LimitsOf, SayWhatCouldNotHaveBeenSeen) {
  SurgeRun run;
  run.input = Steps({20.0}, 120.0);
  const auto limits = LimitsIn(LogOf(run, 1));
  EXPECT_FALSE(limits.at("thrust_curve").is_told);
  EXPECT_FALSE(limits.at("thrust_asymmetry").is_told);
}

// Two levels: any limit or curve between them is another scale.
TEST(LimitsOf, SayThatTwoLevelsShowNeitherSaturationNorCurve) {
  SurgeRun run;
  run.input = Square(20.0, 20.0);
  const auto limits = LimitsIn(LogOf(run, 1));
  for (const char* effect : {"thrust_saturation", "thrust_curve"}) {
    EXPECT_FALSE(limits.at(effect).is_told)
        << effect << ": " << limits.at(effect).low << " to " << limits.at(effect).high;
  }
  EXPECT_TRUE(limits.at("thruster_lag").is_told);
}

}  // namespace
}  // namespace fathom
