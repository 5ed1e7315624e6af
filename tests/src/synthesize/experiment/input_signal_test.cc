// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/experiment/input_signal.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <vector>

#include <gmock/gmock.h>

namespace fathom {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(InputSignal, FollowsASineWithItsPhaseAndOffset) {
  const InputSignal input{2.0, SineInput{.amplitude = 3.0, .frequency = 0.7, .phase = 0.4}};
  EXPECT_DOUBLE_EQ(Value(input, 1.5), 2.0 + 3.0 * std::sin(0.7 * 1.5 + 0.4));
}

TEST(InputSignal, GivesEachLineOfAMultisineItsShareOfTheRms) {
  MultisineInput sines;
  sines.rms = 1.7;
  sines.lowest_frequency = 0.5;
  sines.highest_frequency = 1.1;
  sines.num_lines = 4;  // 0.5, 0.7, 0.9, 1.1: all multiples of 0.1
  InputSignal input{0.0, sines};
  RandomStream random(3, "test");
  DrawRandomParts(input, 100.0, random);

  // Discrete Fourier sums over a common period are exact: the lines are orthogonal there.
  const int num_samples = 1000;
  const double period = 2.0 * kPi / 0.1;
  double sum2 = 0.0;
  std::complex<double> line[13];
  for (int i = 0; i < num_samples; ++i) {
    const double t = i * period / num_samples;
    const double value = Value(input, t);
    sum2 += value * value;
    for (int k = 0; k < 13; ++k) line[k] += value * std::polar(2.0 / num_samples, -0.1 * k * t);
  }
  EXPECT_NEAR(std::sqrt(sum2 / num_samples), 1.7, 1e-12);
  for (int k = 0; k < 13; ++k) {
    const bool is_line = k == 5 || k == 7 || k == 9 || k == 11;
    // Four lines of equal power: amplitude rms * sqrt(2 / 4).
    EXPECT_NEAR(std::abs(line[k]), is_line ? 1.7 * std::sqrt(0.5) : 0.0, 1e-11) << k;
  }
  const auto& phases = std::get<MultisineInput>(input.kind).phases;
  EXPECT_THAT(phases, testing::SizeIs(4));
  EXPECT_NE(phases[0], phases[1]);
}

TEST(InputSignal, SweepsAChirpFromOneFrequencyToTheOtherAndAgain) {
  const ChirpInput chirp{
      .amplitude = 2.0, .first_frequency = 0.2, .last_frequency = 1.4, .sweep = 50.0};
  const InputSignal input{0.0, chirp};
  EXPECT_DOUBLE_EQ(Value(input, 0.0), 0.0);
  // The slope at the start of the sweep is amplitude * first_frequency; the one at its end, with
  // phase 50 * (0.2 + 1.4) / 2 = 40, is amplitude * last_frequency * cos(40).
  const double h = 1e-6;
  EXPECT_NEAR(Value(input, h) / h, 2.0 * 0.2, 1e-6);
  EXPECT_NEAR((Value(input, 50.0 - h) - Value(input, 50.0 - 2.0 * h)) / h,
              2.0 * 1.4 * std::cos(40.0),
              1e-4);
  EXPECT_NEAR(Value(input, 20.0), 2.0 * std::sin(0.2 * 20.0 + 0.5 * 0.024 * 400.0), 1e-12);
  EXPECT_NEAR(Value(input, 63.0), Value(input, 13.0), 1e-12);
}

TEST(InputSignal, HoldsEachLevelAndStartsAgain) {
  const InputSignal input{1.0, StepsInput{.levels = {5.0, 0.0, -3.0}, .hold = 0.1}};
  EXPECT_EQ(Value(input, 0.0), 6.0);
  EXPECT_EQ(Value(input, 0.0999), 6.0);
  EXPECT_EQ(Value(input, 0.1), 1.0);
  EXPECT_EQ(Value(input, 0.2), -2.0);
  EXPECT_EQ(Value(input, 3 * 0.1), 6.0);  // 0.30000000000000004
  EXPECT_EQ(Value(input, 0.3), 6.0);
  EXPECT_EQ(Value(input, 0.5999), -2.0);
}

TEST(InputSignal, RunsThroughAMaximalLengthSequence) {
  InputSignal input{0.0, PrbsInput{.amplitude = 2.0, .hold = 0.5}};
  RandomStream random(5, "test");
  DrawRandomParts(input, 100.0, random);
  std::vector<double> bits;
  for (int i = 0; i < 1023; ++i) {
    bits.push_back(Value(input, 0.5 * i + 0.25) / 2.0);
    ASSERT_EQ(std::abs(bits.back()), 1.0);
    ASSERT_EQ(Value(input, 0.5 * (i + 1023) + 0.25), 2.0 * bits.back());
  }
  // The two marks of such a sequence: one more of one sign than of the other, and a circular
  // autocorrelation of -1 at every shift but 0.
  double sum = 0.0;
  for (const double bit : bits) sum += bit;
  EXPECT_EQ(sum, 1.0);
  for (int shift = 1; shift < 1023; ++shift) {
    double correlation = 0.0;
    for (int i = 0; i < 1023; ++i) correlation += bits[i] * bits[(i + shift) % 1023];
    ASSERT_EQ(correlation, -1.0) << shift;
  }
}

TEST(InputSignal, StartsAPrbsWhereTheSeedSays) {
  const InputSignal input{0.0, PrbsInput{.amplitude = 2.0, .hold = 0.5}};
  const auto bits = [&](std::uint64_t seed) {
    InputSignal drawn = input;
    RandomStream random(seed, "input.surge");
    DrawRandomParts(drawn, 100.0, random);
    std::vector<double> values;
    for (int i = 0; i < 50; ++i) values.push_back(Value(drawn, 0.5 * i));
    return values;
  };
  EXPECT_EQ(bits(1), bits(1));
  EXPECT_NE(bits(1), bits(2));
}

TEST(InputSignal, SwitchesASquareWaveEveryHalfPeriod) {
  const InputSignal input{0.5, SquareInput{.amplitude = 4.0, .frequency = kPi / 3.0}};
  EXPECT_EQ(Value(input, 0.0), 4.5);
  EXPECT_EQ(Value(input, 2.9), 4.5);
  EXPECT_EQ(Value(input, 3.0), -3.5);
  EXPECT_EQ(Value(input, 6.0), 4.5);
}

InputSignal Pilot(double hold, int num_levels, double duration, std::uint64_t seed) {
  PilotInput pilot;
  pilot.amplitude = 40.0;
  pilot.hold = hold;
  pilot.num_levels = num_levels;
  InputSignal input{0.0, pilot};
  RandomStream random(seed, "input.surge");
  DrawRandomParts(input, duration, random);
  return input;
}

TEST(InputSignal, MovesAPilotsStickInStepsOfItsOwn) {
  const InputSignal input = Pilot(3.0, 8, 600.0, 1);
  double largest = 0.0;
  for (int i = 0; i < 6000; ++i) {
    const double levels = Value(input, 0.1 * i) / 5.0;
    ASSERT_NEAR(levels, std::round(levels), 1e-12);
    largest = std::max(largest, std::abs(levels));
  }
  EXPECT_GE(largest, 7.0);
  EXPECT_LE(largest, 8.0);
  EXPECT_NE(Value(input, 100.0), Value(Pilot(3.0, 8, 600.0, 2), 100.0));
  // What is drawn further on leaves the beginning as it is.
  const InputSignal longer = Pilot(3.0, 8, 900.0, 1);
  for (int i = 0; i < 6000; ++i) ASSERT_EQ(Value(longer, 0.1 * i), Value(input, 0.1 * i));
}

TEST(InputSignal, LetsAPilotRestHoldAndPushBothWaysAsOftenAsItsLawSays) {
  const int num_samples = 2000000;  // at 20 Hz, moves of 1 s in the mean: 1e5 of them
  const InputSignal input = Pilot(1.0, 1000, 0.05 * num_samples, 1);
  double sum = 0.0, sum2 = 0.0;
  int num_zeros = 0;
  for (int i = 0; i < num_samples; ++i) {
    const double stick = Value(input, 0.05 * i) / 40.0;
    sum += stick;
    sum2 += stick * stick;
    num_zeros += stick == 0.0 ? 1 : 0;
  }
  // A quarter of the moves goes to zero and a quarter stays: the stick is at zero before one in
  // three of them. So it rests for 1/4 + 1/4 1/3 of the time; 1/1000 more where it sweeps through
  // zero.
  const double five_sigma = 5.0 / std::sqrt(1e5);
  EXPECT_NEAR(static_cast<double>(num_zeros) / num_samples, 1.0 / 3.0, 0.5 * five_sigma + 2e-3);
  EXPECT_NEAR(sum / num_samples, 0.0, 0.5 * five_sigma);
  // Places have mean square S = (1 - 0.2^3) / 2.4 and mean size 0.6; a new one lies on the other
  // side in 7 of 10 cases. Held ones give 2/3 S and S, an even move from a to b (aa + ab + bb) / 3.
  const double S = 0.992 / 2.4;
  const double even = (2.0 / 3.0 * S - 2.0 / 3.0 * 0.4 * 0.36 + S) / 3.0;
  EXPECT_NEAR(sum2 / num_samples, 0.25 * (2.0 / 3.0 * S + S + even), 0.4 * five_sigma);
}

TEST(InputSignal, StepsAtRandomWithinItsBounds) {
  InputSignal input{2.0, RandomStepsInput{.amplitude = 8.0, .shortest = 1.0, .longest = 3.0}};
  RandomStream random(5, "input.surge");
  const double duration = 8000.0;
  DrawRandomParts(input, duration, random);
  const auto& steps = std::get<RandomStepsInput>(input.kind).steps;
  EXPECT_GT(steps.back().end, duration);
  double last_end = 0.0, sum = 0.0, sum_of_squares = 0.0;
  for (const RandomStepsInput::Step& step : steps) {
    EXPECT_GE(step.end - last_end, 1.0 - 1e-9);
    EXPECT_LE(step.end - last_end, 3.0 + 1e-9);
    const double middle = 0.5 * (last_end + step.end);
    if (middle < duration) {
      EXPECT_EQ(Value(input, middle), 2.0 + 8.0 * step.level);
    }
    last_end = step.end;
    sum += step.level;
    sum_of_squares += step.level * step.level;
  }
  // Even in -1 to 1: mean 0, mean square 1/3, of about 4000; four standard deviations.
  const auto n = static_cast<double>(steps.size());
  EXPECT_NEAR(n, 4000.0, 4.0 * 4000.0 * 0.29 / std::sqrt(4000.0));
  EXPECT_NEAR(sum / n, 0.0, 4.0 * std::sqrt(1.0 / 3.0 / n));
  EXPECT_NEAR(sum_of_squares / n, 1.0 / 3.0, 4.0 * std::sqrt(4.0 / 45.0 / n));
}

TEST(InputSignal, ReplaysACommandFromItsFirstStamp) {
  const InputSignal input{1.0, ReplayInput{.file = {}, .command = {{100.0, 100.5}, {3.0, -2.0}}}};
  EXPECT_EQ(Value(input, 0.0), 4.0);
  EXPECT_EQ(Value(input, 0.4), 4.0);
  EXPECT_EQ(Value(input, 0.5), -1.0);
  EXPECT_EQ(Value(input, 9.0), -1.0);
}

}  // namespace
}  // namespace fathom
