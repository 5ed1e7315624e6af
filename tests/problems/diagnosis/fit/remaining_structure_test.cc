// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/fit/remaining_structure.h"

#include "fathom/diagnosis/fit/fit_with_noise.h"
#include "fathom/synthesize/effects/unlisted_effects.h"

#include <string>
#include <utility>
#include <vector>

#include "surge_run.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

SurgeRun Plain() {
  SurgeRun run;
  run.input = Multisine(40.0);
  return run;
}

// What a look finds beside the baseline that is fitted to a run.
template <typename Look>
auto Seen(Look look, const SurgeRun& run, std::uint64_t seed) {
  const std::vector<Log> logs = {LogOf(run, seed)};
  const TrainingData data(MeasuredSegmentsOf(logs, Dof::kSurge).all);
  const StructureFit fit =
      FitBaseline(data, {kSurgeTruth, {}}, std::vector{data.segments()[0].initial});
  return look(data, fit);
}

RemainingStructure RemainingIn(const SurgeRun& run, std::uint64_t seed) {
  return Seen(FindRemainingStructure, run, seed);
}

// Of the p-values of logs with nothing hidden no more may be small than the level says. (Fewer may:
// the noise learned beside so many columns is on the safe side, docs/residual_noise.md.)
TEST(RemainingStructure, IsRarelyFoundWhereNothingIsLeft) {
  const int num_runs = 30;
  int num_small = 0, num_small_of_one = 0;
  for (int seed = 0; seed < num_runs; ++seed) {
    SurgeRun run = Plain();
    run.duration = 60.0;
    run.noise_correlation = seed % 2 == 0 ? 0.0 : 0.7;
    const RemainingStructure remaining = RemainingIn(run, seed);
    EXPECT_GT(remaining.num_columns, 10);
    num_small += remaining.p_value < 0.05;
    num_small_of_one += Seen(FindRemainingOfOneInput, run, seed).p_value < 0.05;
  }
  // Binomial of 30 with 5 %: more than 6 in 0.07 % of cases.
  EXPECT_LE(num_small, 6);
  EXPECT_LE(num_small_of_one, 6);
}

// The columns would leave no noise to measure them by.
TEST(RemainingStructure, IsNotLookedForInTooFewSamples) {
  SurgeRun run = Plain();
  run.duration = 4.0;
  const RemainingStructure remaining = RemainingIn(run, 1);
  EXPECT_EQ(remaining.num_columns, 0);
  EXPECT_EQ(remaining.p_value, 1.0);
}

TEST(RemainingStructure, IsFoundWhereAnEffectIsLeftOut) {
  for (const char* effect : {"thrust_dead_zone:width=15", "thruster_lag:time_constant=0.5"}) {
    SurgeRun run = Plain();
    run.effects = effect;
    EXPECT_LT(RemainingIn(run, 1).p_value, 1e-6) << effect;
  }
}

// A loss that comes slowly is no function of command and speed.
TEST(RemainingStructure, IsFoundWhereTheThrustChangesOverTheRun) {
  SurgeRun run = Plain();
  run.effects = "thrust_fade:rate=0.001";
  const RemainingStructure remaining = RemainingIn(run, 1);
  EXPECT_LT(remaining.p_value, 1e-6);
  EXPECT_LE(remaining.num_columns, 6);  // of the look over time
}

// The catalogue is not asked. Of the eight effects that it does not have, at their usual sizes,
// those are found that act through command and speed and are large here: backlash, heat and wash
// (p-values of 1e-14, 1e-6, 1e-18). The levels of the thrust are lost in the noise; a bump, a slack
// tether, a current that wanders, and a power of speed that the damping nearly has are not seen.
TEST(RemainingStructure, IsFoundWhereAnUnlistedEffectIsLeftOut) {
  int num_found = 0;
  for (const Effect* effect : UnlistedEffects()) {
    SurgeRun run = Plain();
    run.effects = std::string(effect->info().name);
    const double p = RemainingIn(run, 2).p_value;
    num_found += p < 0.01;
    RecordProperty(std::string(effect->info().name), std::to_string(p));
  }
  EXPECT_GE(num_found, 3);
}

// A bump of the force at one place is a function of the place alone.
TEST(RemainingOfOneInput, SeesWhatIsLostAmongAllInputs) {
  SurgeRun run = Plain();
  run.effects = "unlisted.place_bump:force=2:place=0.3:width=0.3";
  run.duration = 120.0;
  const double of_all = RemainingIn(run, 2).p_value;
  const double of_one = Seen(FindRemainingOfOneInput, run, 2).p_value;
  EXPECT_LT(of_one, 1e-3);
  EXPECT_GT(of_all, 10.0 * of_one);
}

TEST(BestFreeForm, IsOfTheInputThatTheMissingForceFollows) {
  const std::vector<std::pair<std::string, std::string>> expected = {
      {"thrust_dead_zone:width=15", "command"},
      {"coulomb_friction:force=8", "velocity"},
      {"position_stiffness:stiffness=3", "displacement"},
      {"thruster_lag:time_constant=0.5", "past command"},
      {"unlisted.thruster_heat:loss=0.01:time_constant=30", "effort of the thrusters so far"}};
  for (const auto& [effect, input] : expected) {
    SurgeRun run = Plain();
    run.effects = effect;
    run.duration = 300.0;
    const FreeForm form = Seen(BestFreeForm, run, 1);
    EXPECT_EQ(form.input, input) << effect;
    EXPECT_GT(form.gain, 20.0) << effect;
  }
}

// Seven looks, the most columns nine: chi squared of 9 less 9 is above 12 in 1 % of cases.
TEST(BestFreeForm, GainsLittleWhereNothingIsLeft) {
  for (const int seed : {1, 2, 3, 4, 5, 6}) {
    const FreeForm form = Seen(BestFreeForm, Plain(), seed);
    EXPECT_FALSE(form.input.empty());
    EXPECT_LT(form.gain, 18.0) << "seed " << seed;
  }
}

}  // namespace
}  // namespace fathom
