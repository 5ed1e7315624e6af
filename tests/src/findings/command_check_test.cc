// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/command_check.h"

#include "fathom/base/random_stream.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::string> CodesOf(const HeldCommand& command, const Segment& segment) {
  std::vector<std::string> codes;
  for (const Finding& finding : CheckCommand(command, {&segment, 1}, "N")) {
    EXPECT_EQ(finding.severity, Severity::kNote);
    codes.push_back(finding.code);
  }
  return codes;
}

// A vehicle of 40 kg for 100 s at 10 Hz. `force`: from time, true speed and a sum of speed errors.
template <typename Force>
std::pair<HeldCommand, Segment> Driven(const Force& force, double duration = 100.0) {
  RandomStream noise(3, "noise");
  HeldCommand command;
  Segment segment;
  double v = 0.0;
  for (int k = 0; 0.1 * k < duration; ++k) {
    const double t = 0.1 * k, measured = v + 0.01 * noise.Normal();
    const double f = force(t, measured);
    command.time.push_back(t);
    command.value.push_back(f);
    segment.time.push_back(t);
    segment.velocity.push_back(measured);
    v += 0.1 * (f - 30.0 * v * std::abs(v) - 5.0 * v) / 40.0;
  }
  return {command, segment};
}

double Multisine(double t) {
  return 10.0 * std::sin(0.3 * t) + 8.0 * std::sin(0.71 * t) + 6.0 * std::sin(1.37 * t);
}

TEST(CheckCommand, SaysNothingOfASquareWaveAndOfTones) {
  const auto [square, of_square] =
      Driven([](double t, double) { return std::fmod(t, 16.0) < 8.0 ? 20.0 : -20.0; });
  EXPECT_THAT(CodesOf(square, of_square), IsEmpty());
  const auto [tones, of_tones] = Driven([](double t, double) { return Multisine(t); });
  EXPECT_THAT(CodesOf(tones, of_tones), IsEmpty());
}

TEST(CheckCommand, SeesAController) {
  const auto [command, segment] = Driven(
      [](double t, double v) { return 80.0 * ((std::fmod(t, 16.0) < 8.0 ? 0.4 : -0.4) - v); });
  EXPECT_THAT(CodesOf(command, segment), ElementsAre("closed_loop"));
}

TEST(CheckCommand, SeesALimit) {
  const auto [command, segment] =
      Driven([](double t, double) { return std::clamp(Multisine(t), -12.0, 12.0); });
  EXPECT_THAT(CodesOf(command, segment), ElementsAre("clipped_command", "clipped_command"));
}

TEST(CheckCommand, SeesAShortLogOfOneStep) {
  const auto [command, segment] =
      Driven([](double t, double) { return t < 3.0 ? 0.0 : 15.0; }, 20.0);
  EXPECT_THAT(CodesOf(command, segment), ElementsAre("short_log", "few_changes"));
}

}  // namespace
}  // namespace fathom
