// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/signals.h"

#include "fathom/base/input_error.h"

#include <cmath>
#include <random>

#include "error_from.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

constexpr double kMass = 80.0, kDamping = 25.0, kBuoyancy = -3.0;

// Position and velocity of kMass dv/dt + kDamping v + kBuoyancy = tau over time `h`, closed form.
struct State {
  double x = 0.0, v = 0.0;

  State After(double h, double tau) const {
    const double steady = (tau - kBuoyancy) / kDamping, decay = std::exp(-kDamping / kMass * h);
    return {x + steady * h + (v - steady) * kMass / kDamping * (1.0 - decay),
            steady + (v - steady) * decay};
  }
};

// Steps of +-20 N, 4.1 s long, at stamps of their own; motion at irregular stamps of about 10 Hz.
struct TankRun {
  Log log;
  std::vector<double> x, v;
};

TankRun StepRun(double duration, unsigned seed = 1) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> jitter(0.7, 1.3);
  TankRun run;
  Stream command = {.time = {}, .columns = {"tau_surge"}, .values = {{}}};
  for (int k = 0; 4.1 * k < duration; ++k) {
    command.time.push_back(4.1 * k);
    command.values[0].push_back(k % 2 == 0 ? 20.0 : -20.0);
  }
  Stream velocity = {.time = {}, .columns = {"u"}, .values = {{}}};
  Stream pose = {.time = {}, .columns = {"x", "y", "z", "qx", "qy", "qz", "qw"}, .values = {}};
  pose.values.resize(7);
  State state;
  double t = 0.0;
  size_t next = 1;
  while (t < duration) {
    velocity.time.push_back(t);
    velocity.values[0].push_back(state.v);
    // Facing against the world's x.
    const double row[7] = {-state.x, 0.3, 1.0, 0.0, 0.0, 1.0, 0.0};
    for (int k = 0; k < 7; ++k) pose.values[k].push_back(row[k]);
    run.x.push_back(state.x);
    run.v.push_back(state.v);
    const double to = t + 0.1 * jitter(generator);
    while (next < command.time.size() && command.time[next] <= to) {
      state = state.After(command.time[next] - t, command.values[0][next - 1]);
      t = command.time[next++];
    }
    state = state.After(to - t, command.values[0][next - 1]);
    t = to;
  }
  pose.time = velocity.time;
  run.log.name = "steps";
  run.log.command = command;
  run.log.velocity = velocity;
  run.log.pose = pose;
  return run;
}

// Root mean square of what the equation of motion misses.
template <typename Force>
double Imbalance(const Segment& segment, Force force) {
  double sum = 0.0;
  int count = 0;
  for (size_t i = 0; i < segment.time.size(); ++i) {
    const double miss = kMass * segment.acceleration[i] + kDamping * segment.smoothed_velocity[i] +
                        kBuoyancy - force(i);
    if (std::isnan(miss)) continue;
    sum += miss * miss;
    ++count;
  }
  EXPECT_GT(count, 100);
  return std::sqrt(sum / count);
}

// Steps of 40 N at any place between the stamps must leave force and acceleration in balance: only
// the trapezoidal rule for the displacement errs, where the velocity has a kink of 0.5 m/s^2, by up
// to 0.5 h^2 / 8 = 6e-4 m; weights of 2 / s for 1 s make that 0.03 N for a quarter of the time.
TEST(Signals, BalanceForceAndAccelerationAcrossStepsOfTheCommand) {
  const TankRun run = StepRun(60.0);
  const Signals signals = SignalsOf(run.log, Dof::kSurge);
  ASSERT_EQ(signals.train.size(), 1u);
  const Segment& segment = signals.train[0];
  const double exact = Imbalance(segment, [&](size_t i) { return segment.smoothed_force[i]; });
  const double sampled =
      Imbalance(segment, [&](size_t i) { return segment.command.At(segment.time[i]); });
  EXPECT_LT(exact, 0.02);
  EXPECT_GT(sampled, 1.0) << "or this test could not fail";
}

TEST(Signals, BalanceForceAndAccelerationOfPosesToo) {
  const TankRun run = StepRun(60.0);
  const Signals signals = SignalsOf(run.log, Dof::kSurge, {.source = Source::kCamera});
  ASSERT_EQ(signals.train.size(), 1u);
  const Segment& segment = signals.train[0];
  EXPECT_LT(Imbalance(segment, [&](size_t i) { return segment.smoothed_force[i]; }), 0.02);
}

TEST(Signals, TakeVelocityAndPositionFromPoses) {
  const TankRun run = StepRun(60.0);
  const Signals signals = SignalsOf(run.log, Dof::kSurge, {.source = Source::kCamera});
  const Segment& segment = signals.train[0];
  ASSERT_EQ(segment.time.size(), run.x.size());
  double sum = 0.0;
  for (size_t i = 0; i < run.x.size(); ++i) {
    EXPECT_NEAR(segment.position[i], run.x[i], 1e-12);
    sum += std::abs(segment.velocity[i] - run.v[i]);
  }
  // A kink of the velocity by 0.5 m/s^2 is rounded off over a window of 1 s: up to 0.05 m/s there.
  EXPECT_LT(sum / static_cast<double>(run.x.size()), 0.01);
  EXPECT_EQ(signals.source, Source::kCamera);
}

// What a depth sensor alone tells is heave, what an attitude alone tells are the turns; no more.
TEST(Signals, TakeFromAPartOfAPoseWhatItTells) {
  TankRun run = StepRun(60.0);
  Log& log = run.log;
  log.command->columns = {"tau_heave"};
  log.velocity.reset();
  const Stream pose = *log.pose;
  log.pose = Stream{pose.time, {"z"}, {run.x}};
  const Signals heave = SignalsOf(log, Dof::kHeave, {.source = Source::kCamera});
  ASSERT_EQ(heave.train[0].position.size(), run.x.size());
  for (size_t i = 0; i < run.x.size(); ++i)
    EXPECT_NEAR(heave.train[0].position[i], run.x[i], 1e-12);
  EXPECT_THAT(heave.remarks, Contains(HasSubstr("stays level")));

  const auto error = [&](Dof dof) -> std::string {
    return ErrorFrom([&] {
      log.command->columns = {std::string(ForceColumn(dof))};
      SignalsOf(log, dof, {.source = Source::kCamera});
    });
  };
  EXPECT_THAT(error(Dof::kSurge), HasSubstr("tells nothing of surge; expected a position"));
  EXPECT_THAT(error(Dof::kRoll), HasSubstr("tells nothing of roll; expected an attitude"));

  std::vector<double> sines, cosines;  // of half a roll as large as the way was
  for (const double x : run.x) {
    sines.push_back(std::sin(0.5 * x));
    cosines.push_back(std::cos(0.5 * x));
  }
  const std::vector<double> none(run.x.size(), 0.0);
  log.pose = Stream{pose.time, {"qx", "qy", "qz", "qw"}, {sines, none, none, cosines}};
  log.command->columns = {"tau_roll"};
  const Signals roll = SignalsOf(log, Dof::kRoll, {.source = Source::kCamera});
  ASSERT_EQ(roll.train[0].position.size(), run.x.size());
  for (size_t i = 0; i < run.x.size(); ++i) EXPECT_NEAR(roll.train[0].position[i], run.x[i], 1e-9);
  EXPECT_THAT(error(Dof::kHeave), HasSubstr("tells nothing of heave; expected z"));
}

TEST(Signals, TakeTheMeasuredVelocityAsItIs) {
  const TankRun run = StepRun(30.0);
  const Signals signals = SignalsOf(run.log, Dof::kSurge);
  EXPECT_EQ(signals.train[0].velocity, run.log.velocity->values[0]);
  EXPECT_EQ(signals.train[0].time, run.log.velocity->time);
  EXPECT_TRUE(signals.train[0].position.empty());
  EXPECT_EQ(signals.force_unit, "N");
}

// Whatever the held-out samples are, the training segments stay the same to the last bit.
TEST(Signals, KeepHeldOutDataOutOfTraining) {
  for (const Source source : {Source::kPoseEstimator, Source::kCamera}) {
    TankRun run = StepRun(90.0);
    run.log.held_out = {{30.0, 50.0}};
    const Signals before = SignalsOf(run.log, Dof::kSurge, {.source = source});
    for (size_t i = 0; i < run.log.velocity->time.size(); ++i) {
      if (!run.log.held_out[0].Contains(run.log.velocity->time[i])) continue;
      run.log.velocity->values[0][i] += std::sin(1.0 * i);
      run.log.pose->values[0][i] += std::sin(1.0 * i);
    }
    const Signals after = SignalsOf(run.log, Dof::kSurge, {.source = source});
    ASSERT_EQ(before.train.size(), 2u);
    ASSERT_EQ(before.held_out.size(), 1u);
    EXPECT_GE(before.held_out[0].time.front(), 30.0);
    EXPECT_LT(before.held_out[0].time.back(), 50.0);
    EXPECT_NE(before.held_out[0].velocity, after.held_out[0].velocity);
    for (int k = 0; k < 2; ++k) {
      EXPECT_EQ(before.train[k].velocity, after.train[k].velocity);
      EXPECT_THAT(
          before.train[k].smoothed_force,
          ::testing::Pointwise(::testing::NanSensitiveDoubleEq(), after.train[k].smoothed_force));
      EXPECT_THAT(
          before.train[k].acceleration,
          ::testing::Pointwise(::testing::NanSensitiveDoubleEq(), after.train[k].acceleration));
    }
  }
}

TEST(Signals, TrainOnEverythingIfAskedTo) {
  TankRun run = StepRun(90.0);
  run.log.held_out = {{30.0, 50.0}};
  const Signals signals = SignalsOf(run.log, Dof::kSurge, {.split_held_out = false});
  EXPECT_EQ(signals.train.size(), 1u);
  EXPECT_TRUE(signals.held_out.empty());
}

TEST(Signals, LeaveOutAndCountMotionBeforeTheFirstCommand) {
  TankRun run = StepRun(60.0);
  for (double& t : run.log.command->time) t += 7.0;
  const auto& time = run.log.velocity->time;
  const auto early = std::lower_bound(time.begin(), time.end(), 7.0) - time.begin();
  const Signals signals = SignalsOf(run.log, Dof::kSurge);
  EXPECT_EQ(signals.train[0].time.front(), time[early]);
  EXPECT_THAT(
      signals.remarks,
      Contains("Left out: " + std::to_string(early) + " motion samples before the first command."));
}

TEST(Signals, StartANewSegmentAfterASilenceAndCountShortOnes) {
  TankRun run = StepRun(120.0);
  // Silence from 20 to 55 s, then 5 samples, silence to 100 s.
  Stream& velocity = *run.log.velocity;
  Stream kept = {.time = {}, .columns = {"u"}, .values = {{}}};
  int num_island = 0;
  for (size_t i = 0; i < velocity.time.size(); ++i) {
    const double t = velocity.time[i];
    const bool island = t >= 55.0 && num_island < 5;
    if (!(t < 20.0 || t >= 100.0 || island)) continue;
    if (island) ++num_island;
    kept.time.push_back(t);
    kept.values[0].push_back(velocity.values[0][i]);
  }
  velocity = kept;
  const Signals signals = SignalsOf(run.log, Dof::kSurge);
  ASSERT_EQ(signals.train.size(), 2u);
  EXPECT_LT(signals.train[0].time.back(), 20.0);
  EXPECT_GE(signals.train[1].time.front(), 100.0);
  EXPECT_THAT(signals.remarks,
              Contains(HasSubstr("gaps of over 30 s, 2 times. Each gap starts a new segment.")));
  EXPECT_THAT(signals.remarks,
              Contains(HasSubstr("1 segment of fewer than 10 samples (5 samples)")));
  // The command that holds at a segment's start is the one given before it.
  EXPECT_EQ(signals.train[1].command.At(signals.train[1].time.front()),
            run.log.command->values[0][24]);  // 24 * 4.1 s = 98.4 s
}

TEST(Signals, HaveNoAccelerationNearTheEnds) {
  const TankRun run = StepRun(60.0);
  const Segment segment = SignalsOf(run.log, Dof::kSurge, {.window = 2.0}).train[0];
  for (size_t i = 0; i < segment.time.size(); ++i) {
    const bool inside =
        segment.time[i] - segment.time.front() > 1.0 && segment.time.back() - segment.time[i] > 1.0;
    EXPECT_EQ(std::isfinite(segment.acceleration[i]), inside) << segment.time[i];
  }
}

TEST(Signals, SayWhatALogLacks) {
  TankRun run = StepRun(30.0);
  const auto message = [&](Dof dof, Source source) -> std::string {
    return ErrorFrom([&] { SignalsOf(run.log, dof, {.source = source}); });
  };
  EXPECT_THAT(message(Dof::kHeave, Source::kPoseEstimator), HasSubstr("'w' is missing"));
  EXPECT_THAT(message(Dof::kHeave, Source::kCamera), HasSubstr("'tau_heave' is missing"));
  run.log.pose.reset();
  EXPECT_THAT(message(Dof::kSurge, Source::kCamera), HasSubstr("pose.csv"));
  EXPECT_THAT(message(Dof::kSurge, Source::kCamera), HasSubstr("pose_estimator"));
  run.log.command->columns = {"thruster_1"};
  EXPECT_THAT(message(Dof::kSurge, Source::kPoseEstimator), HasSubstr("vehicle file"));
  run.log.command.reset();
  EXPECT_THAT(message(Dof::kSurge, Source::kPoseEstimator), HasSubstr("no command"));
}

std::string RefusalOfSource(const Log& log, Source source) {
  return ErrorFrom([&] { SignalsOf(log, Dof::kSurge, {.source = source}); });
}

TEST(Signals, RefuseCommandAndMotionThatDoNotOverlap) {
  TankRun run = StepRun(30.0);
  const size_t num = run.log.velocity->time.size();
  for (double& t : run.log.command->time) t += 1e6;
  EXPECT_EQ(RefusalOfSource(run.log, Source::kPoseEstimator),
            "velocity.csv: 0 of " + std::to_string(num) +
                " samples come after the first command, expected at least 10 in a row. Check the "
                "clocks of command and motion.");
}

// The clocks have no part in it, and a log of detections has no pose.csv.
TEST(Signals, SayHowFewPosesThereAreAndWhereTheyComeFrom) {
  TankRun run = StepRun(30.0);
  Stream& pose = *run.log.pose;
  pose.time.resize(3);
  for (auto& column : pose.values) column.resize(3);
  EXPECT_EQ(RefusalOfSource(run.log, Source::kCamera),
            "pose.csv: holds 3 frames with a pose, expected at least 10 in a row.");
  run.log.detections = Stream{};
  EXPECT_EQ(RefusalOfSource(run.log, Source::kCamera),
            "detections.csv: holds 3 frames with a pose, expected at least 10 in a row.");
}

TEST(Signals, RefuseMotionThatIsAllInPieces) {
  TankRun run = StepRun(30.0);
  std::vector<double>& time = run.log.velocity->time;
  for (size_t i = 0; i < time.size(); ++i) time[i] = 40.0 * static_cast<double>(i);
  EXPECT_EQ(RefusalOfSource(run.log, Source::kPoseEstimator),
            "velocity.csv: no segment between gaps of over 30 s and the ends of held-out intervals "
            "has 10 samples, expected at least one.");
}

TEST(Signals, RefuseBrokenOptions) {
  const TankRun run = StepRun(30.0);
  EXPECT_THROW(SignalsOf(run.log, Dof::kSurge, {.longest_gap = 0.0}), InputError);
  EXPECT_THROW(SignalsOf(run.log, Dof::kSurge, {.window = -1.0}), InputError);
  EXPECT_THROW(SignalsOf(run.log, Dof::kSurge, {.order = 0}), InputError);
  EXPECT_THROW(ParseSource("sonar"), InputError);
  EXPECT_EQ(ParseSource("camera"), Source::kCamera);
}

TEST(Signals, SayWhichWindowTheyUse) {
  const TankRun run = StepRun(60.0);
  EXPECT_THAT(SignalsOf(run.log, Dof::kSurge).remarks, Contains(HasSubstr("cross-validation")));
  EXPECT_THAT(SignalsOf(run.log, Dof::kSurge, {.window = 1.5}).remarks,
              Contains(StartsWith("A Savitzky-Golay filter gives least squares, where fits begin, "
                                  "its accelerations: window 1.5 s")));
  EXPECT_THAT(
      SignalsOf(run.log, Dof::kSurge, {.source = Source::kCamera}).remarks,
      Contains(StartsWith("A Savitzky-Golay filter makes velocities of the poses: window ")));
  EXPECT_THAT(SignalsOf(run.log, Dof::kSurge).remarks, Not(Contains(HasSubstr("rotation step"))));
}

}  // namespace
}  // namespace fathom
