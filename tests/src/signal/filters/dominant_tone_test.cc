// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/filters/dominant_tone.h"

#include <cmath>
#include <functional>
#include <random>

#include <gtest/gtest.h>

namespace fathom {
namespace {

HeldCommand IrregularCommand(double duration, const std::function<double(double)>& value) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> step(0.02, 0.2);
  HeldCommand command;
  for (double t = 1000.0; t < 1000.0 + duration; t += step(generator)) {
    command.time.push_back(t);
    command.value.push_back(value(t));
  }
  return command;
}

TEST(DominantTone, FindsASingleSineOnIrregularStamps) {
  const HeldCommand command =
      IrregularCommand(137.0, [](double t) { return 5.0 + 52.9 * std::sin(0.2 * t); });
  const Tone tone = DominantTone(command, 137.0);
  EXPECT_NEAR(tone.frequency, 0.2, 2e-3);
  EXPECT_GT(tone.share, 0.99);
}

TEST(DominantTone, MeasuresTheShareAmongSeveral) {
  const HeldCommand command = IrregularCommand(300.0, [](double t) {
    return 2.0 * std::sin(0.5 * t) + std::sin(1.3 * t) + std::sin(2.7 * t);
  });
  const Tone tone = DominantTone(command, 300.0);
  EXPECT_NEAR(tone.frequency, 0.5, 2e-3);
  EXPECT_NEAR(tone.share, 4.0 / 6.0, 0.02);
}

TEST(DominantTone, FindsNoneInAConstantCommand) {
  const Tone tone = DominantTone(IrregularCommand(60.0, [](double) { return 3.0; }), 60.0);
  EXPECT_TRUE(std::isnan(tone.frequency));
  EXPECT_EQ(tone.share, 0.0);
}

TEST(DominantTone, TakesTheWholeCommandUnlessToldOtherwise) {
  const HeldCommand command =
      IrregularCommand(60.0, [](double t) { return std::sin((t < 1030.0 ? 0.5 : 1.3) * t); });
  const double duration = command.time.back() - command.time.front();
  EXPECT_EQ(DominantTone(command).frequency, DominantTone(command, duration).frequency);
  EXPECT_NE(DominantTone(command).share, DominantTone(command, 0.5 * duration).share);
  EXPECT_EQ(DominantTone({{0.0}, {1.0}}).share, 0.0);
  EXPECT_EQ(DominantTone({{}, {}}).share, 0.0);
}

}  // namespace
}  // namespace fathom
