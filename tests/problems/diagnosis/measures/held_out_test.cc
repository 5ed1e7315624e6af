// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/measures/held_out.h"

#include "fathom/base/random_stream.h"
#include "fathom/diagnosis/data/measured_segments.h"
#include "fathom/diagnosis/judge/refutation.h"
#include "fathom/vehicle/effects/catalogue.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "surge_run.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

// 300 s at 5 Hz whose misses are Gaussian with a correlation time, about a measured zero.
FreeRun Misses(double std, double correlation_time, std::uint64_t seed, const char* purpose) {
  RandomStream random(seed, purpose);
  FreeRun run;
  const double h = 0.2, kept = std::exp(-h / correlation_time);
  double miss = std * random.Normal();
  for (int i = 0; i < 1500; ++i) {
    run.time.push_back(h * i);
    run.measured.push_back(0.0);
    run.predicted.push_back(miss);
    miss = kept * miss + std * std::sqrt(1.0 - kept * kept) * random.Normal();
  }
  return run;
}

TEST(FiguresOfRuns, AreThoseWorkedOutByHand) {
  const FreeRun a = {{0.0, 1.0, 3.0}, {1.0, -2.0, 4.0}, {1.5, -2.0, 3.0}};
  const FreeRun b = {{10.0, 11.0}, {0.5, 0.5}, {0.0, 1.25}};
  const std::vector<FreeRun> runs = {a, b};
  const FitFigures figures = FiguresOfRuns(runs);
  EXPECT_EQ(figures.num_samples, 5);
  EXPECT_DOUBLE_EQ(figures.duration, 4.0);
  EXPECT_DOUBLE_EQ(figures.mae, (0.5 + 0.0 + 1.0 + 0.5 + 0.75) / 5.0);
  EXPECT_DOUBLE_EQ(figures.nmae, 2.75 / 8.0);
  EXPECT_TRUE(std::isnan(FiguresOfRuns({}).mae));
}

// Of positions: they count from where the run begins.
TEST(FiguresOfRuns, OfPositionsDoNotDependOnTheOrigin) {
  SurgeRun poses;
  poses.input = Multisine(30.0);
  poses.has_velocity = false;
  poses.has_poses = true;
  const Log log = LogOf(poses, 1);
  const MeasuredSegment segment = MeasuredSegmentsOf({&log, 1}, Dof::kSurge).all.front();
  MeasuredSegment elsewhere = segment;
  for (double& value : elsewhere.displacement) value += 100.0;
  elsewhere.initial.position += 100.0;
  const auto nmae = [](const MeasuredSegment& measured, const ExtendedModel& model) {
    const auto run = FreeRunOver(measured, model);
    return FiguresOfRuns(std::vector{run.value()}).nmae;
  };
  const ExtendedModel wrong = {{1200.0, 60.0, 39.0, -0.8}, {}};
  EXPECT_GT(nmae(segment, wrong), 0.05);
  EXPECT_NEAR(nmae(elsewhere, wrong), nmae(segment, wrong), 1e-6);
  // Nothing moves it, not even from where it seems to begin.
  const ExtendedModel held = {{1e9, 0.0, 2e9, 0.0}, {}};
  EXPECT_NEAR(nmae(elsewhere, held), 1.0, 0.05);
}

TEST(GainOf, IsTheShareOfTheErrorThatGoes) {
  const FreeRun before = {{0.0, 1.0}, {0.0, 0.0}, {3.0, -1.0}};
  const FreeRun after = {{0.0, 1.0}, {0.0, 0.0}, {-0.5, 0.5}};
  const Gain gain = GainOf(std::vector{before}, std::vector{after});
  EXPECT_DOUBLE_EQ(gain.value, 0.75);
  EXPECT_TRUE(std::isnan(gain.low));  // one block says nothing of its scatter
  EXPECT_TRUE(std::isnan(gain.high));
  EXPECT_TRUE(std::isnan(GainOf({}, {}).value));
}

// Five blocks, of which one has all of the error that is left: by its scatter the gain of 0.8 would
// reach 1.36.
TEST(GainOf, HasNoIntervalBeyondAllOfTheError) {
  FreeRun before, after;
  for (int i = 0; i < 50; ++i) {
    before.time.push_back(i);
    before.measured.push_back(0.0);
    before.predicted.push_back(1.0);
    after.predicted.push_back(i < 10 ? 1.0 : 0.0);
  }
  after.time = before.time;
  after.measured = before.measured;
  const Gain gain = GainOf(std::vector{before}, std::vector{after});
  EXPECT_DOUBLE_EQ(gain.value, 0.8);
  EXPECT_LT(gain.low, 0.8);
  EXPECT_EQ(gain.high, 1.0);
}

// The same with 50 s: eight blocks, whose interval is Student's of seven degrees of freedom.
TEST(GainOf, HasAWiderIntervalFromFewBlocks) {
  const int num_runs = 1000;
  int outside = 0;
  for (int seed = 0; seed < num_runs; ++seed) {
    const auto part = [&](double std, const char* purpose) {
      FreeRun run = Misses(std, 0.5, seed, purpose);
      for (auto* column : {&run.time, &run.measured, &run.predicted}) column->resize(250);
      return std::vector{run};
    };
    const Gain gain = GainOf(part(1.0, "before"), part(0.7, "after"));
    outside += gain.low > 0.3 || gain.high < 0.3;
  }
  EXPECT_NEAR(outside, 0.05 * num_runs, 3.5 * 0.007 * num_runs);
}

// Six logs, each of which has a share of its own: the interval is Student's of five degrees of
// freedom over the logs, however long they are.
TEST(GainOverLogs, HasAnIntervalThatHoldsTheTrueGainOfLogs) {
  const int num_runs = 2000;
  std::mt19937 random(3);
  std::normal_distribution<double> own(0.0, 0.2);
  int outside = 0;
  for (int k = 0; k < num_runs; ++k) {
    std::vector<FreeRun> before, after;
    for (int log = 0; log < 6; ++log) {
      FreeRun run = {{}, {}, {}, std::to_string(log)};
      for (int i = 0; i < 100; ++i) {
        run.time.push_back(i);
        run.measured.push_back(0.0);
        run.predicted.push_back(1.0);
      }
      before.push_back(run);
      const double left = 0.7 + own(random);
      for (double& value : run.predicted) value = left;
      after.push_back(run);
    }
    const Gain gain = GainOverLogs(before, after);
    EXPECT_EQ(gain.num_logs, 6U);
    outside += gain.low > 0.3 || gain.high < 0.3;
  }
  // A share of 2000 has a standard deviation of 0.5 %.
  EXPECT_NEAR(outside, 0.05 * num_runs, 3.5 * 0.005 * num_runs);
}

// Two logs of which one gains 0.4 and the other loses 0.2: 0.1 in all, within 12.7 times 0.3.
TEST(GainOverLogs, IsWideFromTwoLogs) {
  const auto run = [](double predicted, const char* log) {
    return FreeRun{{0.0, 1.0}, {0.0, 0.0}, {predicted, predicted}, log};
  };
  const Gain gain = GainOverLogs(std::vector{run(1.0, "a"), run(1.0, "b")},
                                 std::vector{run(0.6, "a"), run(1.2, "b")});
  EXPECT_NEAR(gain.value, 0.1, 1e-12);
  EXPECT_NEAR(gain.low, 0.1 - 12.706 * 0.3, 1e-9);
  EXPECT_EQ(gain.high, 1.0);
  EXPECT_EQ(gain.num_better, 1U);
  EXPECT_FALSE(IsConfirmedByLogs(gain));
}

TEST(IsConfirmedByLogs, OfCertainGainsAndOfGainsInEachLog) {
  const auto gain = [](double value, double low, std::size_t better) {
    return Gain{.value = value, .low = low, .high = 1.0, .num_logs = 5, .num_better = better};
  };
  EXPECT_TRUE(IsConfirmedByLogs(gain(0.3, 0.01, 4)));
  EXPECT_FALSE(IsConfirmedByLogs(gain(0.3, -0.01, 4)));
  EXPECT_TRUE(IsConfirmedByLogs(gain(0.3, -0.01, 5)));
  EXPECT_FALSE(IsConfirmedByLogs(gain(0.005, -0.01, 5)));  // a trace
}

// Misses of 1 and 0.7 that share no chance: in the mean a gain of 0.3, whatever their colour.
TEST(GainOf, HasAnIntervalThatHoldsTheTrueGain) {
  const int num_runs = 1000;
  int below = 0, above = 0;
  for (int seed = 0; seed < num_runs; ++seed) {
    const std::vector<FreeRun> before = {Misses(1.0, 1.5, seed, "before")};
    const std::vector<FreeRun> after = {Misses(0.7, 1.5, seed, "after")};
    const Gain gain = GainOf(before, after);
    below += gain.high < 0.3;
    above += gain.low > 0.3;
  }
  // A share of 1000 has a standard deviation of 0.7 %.
  EXPECT_NEAR(below + above, 0.05 * num_runs, 3.5 * 0.007 * num_runs);
  EXPECT_LT(std::max(below, above), 0.06 * num_runs);  // neither side has it all
}

// Poses that show 5 % too much, beside velocities that are right: these gain nothing. The true
// model with the scale misses white noise of 1 mm, of which a straight line through the 100 poses
// of a block takes 2 %; without it, 5 % of how the vehicle moves about that line as well.
TEST(GainOf, IsInThePosesWhereThePosesAloneAreWrong) {
  SurgeRun run;
  run.input = Multisine(40.0);
  run.has_poses = true;
  run.position_noise = 0.001;
  run.effects = "pose_scale:error=0.05";
  Log log = LogOf(run, 8);
  log.held_out = {{60.0, 120.0}};
  const MeasuredSegments segments = MeasuredSegmentsOf(std::span<const Log>(&log, 1), Dof::kSurge);
  ASSERT_EQ(segments.all.size(), 2u);
  const ExtendedModel without = {kSurgeTruth, {}};
  const ExtendedModel with = {kSurgeTruth, {{FindEffect("pose_scale"), {}, {0.05}}}};
  Scored scored = Score({segments.all[1]}, without, with);

  const Gain in_velocities = GainOf(scored, false);
  EXPECT_FALSE(in_velocities.is_in_poses);
  EXPECT_NEAR(in_velocities.value, 0.0, 1e-4);

  ASSERT_EQ(scored.poses_after.size(), 1u);
  const double noise = 0.001 * std::sqrt(2.0 / std::numbers::pi * 0.98);
  const double after = FiguresOfRuns(scored.poses_after).mae;
  EXPECT_NEAR(after, noise, 0.1 * noise);
  const Gain in_poses = GainOf(scored, true);
  EXPECT_TRUE(in_poses.is_in_poses);
  EXPECT_DOUBLE_EQ(in_poses.value, 1.0 - after / FiguresOfRuns(scored.poses_before).mae);
  EXPECT_GT(in_poses.low, 0.5);

  // Without poses there is nothing but the velocities.
  scored.poses_before.clear();
  scored.poses_after.clear();
  EXPECT_FALSE(GainOf(scored, true).is_in_poses);
}

// Eight blocks, `share` of whose misses remain.
std::vector<FreeRun> WithMiss(double share) {
  FreeRun run;
  for (int i = 0; i < 8; ++i) {
    run.time.push_back(10.0 * i);
    run.measured.push_back(0.0);
    run.predicted.push_back(share);
  }
  return {run};
}

// What acts on the poses alone may lose a trace of them, as a jump before the held-out data does,
// and less of one in the velocities. Anything else may not.
TEST(RefutingGain, IsMoreThanATraceOfWhatActsOnThePosesAlone) {
  const auto refuting = [](double velocities, double poses, bool on_poses_alone) {
    return RefutingGain({WithMiss(1.0), WithMiss(velocities), WithMiss(1.0), WithMiss(poses)},
                        on_poses_alone);
  };
  EXPECT_FALSE(refuting(1.001, 1.009, true));
  EXPECT_TRUE(refuting(1.001, 1.011, true)->is_in_poses);
  EXPECT_FALSE(refuting(1.006, 0.5, true)->is_in_poses);
  EXPECT_TRUE(refuting(1.001, 0.5, false));
  EXPECT_FALSE(refuting(0.999, 1.5, false));
}

// The true model over the second minute of poses with white noise of 1 mm. Twenty of them tell the
// first speed to 1 mm / sqrt(20 * 0.58^2 s^2) = 0.4 mm/s, which this vehicle carries for some 13 s:
// 5 mm, four times of which is allowed. The mean speed of these two seconds is that of their
// middle, 20 mm/s or more off at this acceleration (40 N / 890 kg): 0.3 m.
TEST(FreeRunOver, StartsAtTheSpeedThatPosesShow) {
  SurgeRun run;
  run.input = Multisine(40.0);
  run.has_velocity = false;
  run.has_poses = true;
  run.position_noise = 0.001;
  Log log = LogOf(run, 8);
  log.held_out = {{60.0, 120.0}};
  const MeasuredSegments segments = MeasuredSegmentsOf(std::span<const Log>(&log, 1), Dof::kSurge);
  ASSERT_EQ(segments.all.size(), 2u);
  ExtendedModel truth;
  truth.baseline = kSurgeTruth;
  const auto free_run = FreeRunOver(segments.all[1], truth);
  ASSERT_TRUE(free_run);
  ASSERT_GT(free_run->time.size(), 500u);
  double sum = 0.0;
  for (size_t i = 0; i < free_run->time.size(); ++i) {
    sum += std::abs(free_run->predicted[i] - free_run->measured[i]);
  }
  EXPECT_LT(sum / static_cast<double>(free_run->time.size()), 0.02);
}

// The same of velocities through a lag, that this interval begins amid an acceleration of up to
// 40 N / 890 kg, 45 mm/s^2: at the speed that is shown it would start 1.2 s of that off. Of white
// noise of 1 mm/s, which misses 0.8 mm/s in the mean, 20 readings tell the slope to 0.39 mm/s^2,
// and the speed behind a lag of 1.2 s to 0.5 mm/s; four times of that is allowed.
TEST(FreeRunOver, StartsWhereALaggingSensorShowsTheFirstReadings) {
  SurgeRun run;
  run.input = Multisine(40.0);
  run.velocity_noise = 0.001;
  run.effects = "sensor_lag:time_constant=1.2";
  Log log = LogOf(run, 8);
  log.held_out = {{60.0, 120.0}};
  const MeasuredSegments segments = MeasuredSegmentsOf(std::span<const Log>(&log, 1), Dof::kSurge);
  ASSERT_EQ(segments.all.size(), 2u);
  const ExtendedModel truth = {kSurgeTruth, {{FindEffect("sensor_lag"), {}, {1.2}}}};
  const auto free_run = FreeRunOver(segments.all[1], truth);
  ASSERT_TRUE(free_run);
  ASSERT_GT(free_run->time.size(), 500u);
  EXPECT_LT(FiguresOfRuns(std::vector{*free_run}).mae, 0.0008 + 4.0 * 0.0005);
}

}  // namespace
}  // namespace fathom
