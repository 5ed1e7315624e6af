// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/command_clock.h"

#include "fathom/base/random_stream.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;

// 40 kg that moves by a command which acts `delay` later: 10 Hz, noise of 5 mm/s.
struct Steered {
  HeldCommand command;
  std::vector<Segment> segments;
};

Steered Simulated(const std::function<double(double)>& force,
                  double delay,
                  double duration,
                  std::uint64_t seed) {
  constexpr double kStep = 0.01;
  RandomStream noise(seed, "speed");
  Steered run;
  for (double t = -15.0; t < duration + 15.0; t += 0.1) {
    run.command.time.push_back(t);
    run.command.value.push_back(force(t));
  }
  Segment segment;
  double v = 0.0;
  int k = 0;
  for (double t = -10.0; t < duration; t = -10.0 + kStep * ++k) {
    if (t >= 0.0 && k % 10 == 0) {
      segment.time.push_back(t);
      segment.velocity.push_back(v + 0.005 * noise.Normal());
    }
    v += kStep * (run.command.At(t - delay) - 30.0 * v * std::abs(v) - 5.0 * v + 1.0) / 40.0;
  }
  segment.command = run.command;
  run.segments = {segment};
  return run;
}

// Steps of random size and length: no period.
std::function<double(double)> RandomSteps(std::uint64_t seed) {
  RandomStream random(seed, "steps");
  std::vector<double> from, size;
  for (double t = -20.0; t < 600.0; t += 2.0 + 6.0 * random.Uniform()) {
    from.push_back(t);
    size.push_back(40.0 * (random.Uniform() - 0.5));
  }
  return [=](double t) {
    std::size_t i = 0;
    while (i + 1 < from.size() && from[i + 1] <= t) ++i;
    return size[i];
  };
}

class CommandDelays : public ::testing::TestWithParam<double> {};

TEST_P(CommandDelays, AreMeasured) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Steered run = Simulated(RandomSteps(seed), GetParam(), 120.0, seed);
    const auto found = FindCommandDelay(run.command, run.segments);
    ASSERT_TRUE(found);
    // Half a period of the command's samples is held on average.
    EXPECT_NEAR(found->delay, GetParam(), 0.15);
  }
}

INSTANTIATE_TEST_SUITE_P(Seconds,
                         CommandDelays,
                         ::testing::Values(-7.0, -3.0, -0.5, 0.6, 2.2, 8.0));

// Of logs whose clocks agree none may get a warning.
// A log joined from two others, each with its own clock.
TEST(CommandClock, FarApartIsFoundWhereTheCommandActsAtNoNearerTime) {
  for (const double offset : {-31.0, 13.0, 40.0}) {
    Steered run = Simulated(RandomSteps(5), 0.0, 400.0, 5);
    for (double& t : run.segments[0].time) t += offset;
    const auto found = FindCommandDelay(run.command, run.segments);
    ASSERT_TRUE(found) << offset;
    EXPECT_NEAR(found->delay, offset, 0.3);
  }
}

// Motion that another command drove: no clock puts these together.
TEST(CommandClock, SaysNothingWhereTheCommandDoesNotAct) {
  int num_told = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const Steered run = Simulated(RandomSteps(seed), 0.0, 300.0, seed);
    const Steered other = Simulated(RandomSteps(seed + 1000), 0.0, 300.0, seed + 1000);
    num_told += FindCommandDelay(other.command, run.segments) ? 1 : 0;
  }
  EXPECT_EQ(num_told, 0);
}

TEST(CommandClock, SaysNothingOfClocksThatAgree) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Steered run = Simulated(RandomSteps(seed), 0.0, 100.0, seed);
    EXPECT_FALSE(CheckCommandClock(run.command, run.segments)) << seed;
  }
}

// 12 tones from 0.1 to 1.6 rad/s.
std::function<double(double)> RandomTones(std::uint64_t seed) {
  RandomStream random(seed, "tones");
  std::vector<double> phase;
  for (int i = 0; i < 12; ++i) phase.push_back(6.28 * random.Uniform());
  return [=](double t) {
    double sum = 0.0;
    for (std::size_t i = 0; i < phase.size(); ++i) {
      sum += 6.0 * std::sin((0.1 + 1.5 / 11.0 * static_cast<double>(i)) * t + phase[i]);
    }
    return sum;
  };
}

// What the speed is in a gap of 10 s nobody knows.
TEST(CommandClock, SaysNothingOfAGapWhereClocksAgree) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Steered run = Simulated(RandomTones(seed), 0.0, 150.0, seed);
    Segment& segment = run.segments[0];
    segment.time.erase(segment.time.begin() + 500, segment.time.begin() + 600);
    segment.velocity.erase(segment.velocity.begin() + 500, segment.velocity.begin() + 600);
    EXPECT_FALSE(CheckCommandClock(run.command, run.segments)) << seed;
  }
}

// A sensor that writes its last value for 40 s does not say when the vehicle moved.
TEST(CommandClock, SaysNothingOfAStuckSensorWhereClocksAgree) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Steered run = Simulated(RandomTones(seed), 0.0, 150.0, seed);
    std::vector<double>& velocity = run.segments[0].velocity;
    std::fill(velocity.begin() + 500, velocity.begin() + 900, velocity[500]);
    EXPECT_FALSE(CheckCommandClock(run.command, run.segments)) << seed;
  }
}

TEST(CommandClock, SaysNothingOfASineWhoseDelayIsAnotherInertia) {
  const auto sine = [](double t) { return 20.0 * std::sin(0.2 * t); };
  const Steered run = Simulated(sine, 2.2, 200.0, 1);
  const auto found = FindCommandDelay(run.command, run.segments);
  // Nothing, or the truth.
  EXPECT_NEAR(found ? found->delay : 2.2, 2.2, 0.5);
}

TEST(CommandClock, WarnsOfMotionBeforeItsCommand) {
  const Steered early = Simulated(RandomSteps(5), -3.0, 120.0, 5);
  const auto finding = CheckCommandClock(early.command, early.segments);
  ASSERT_TRUE(finding);
  EXPECT_EQ(finding->severity, Severity::kWarning);
  EXPECT_THAT(finding->sentence, HasSubstr("s before the command"));
  const Steered late = Simulated(RandomSteps(5), 0.6, 120.0, 5);
  EXPECT_EQ(CheckCommandClock(late.command, late.segments)->severity, Severity::kNote);
}

TEST(CommandClock, CorrelatesMostAtTheDelayThatItFinds) {
  const Steered run = Simulated(RandomSteps(5), 2.2, 120.0, 5);
  const DelayCurve curve = CommandDelayCurve(run.command, run.segments);
  ASSERT_EQ(curve.delay.size(), 401u);
  const auto most = std::max_element(curve.correlation.begin(), curve.correlation.end());
  const auto at = static_cast<std::size_t>(most - curve.correlation.begin());
  EXPECT_NEAR(curve.delay[at], 2.2, 0.15);
  EXPECT_GT(*most, 0.9);
  EXPECT_LE(*most, 1.0);
}

}  // namespace
}  // namespace fathom
