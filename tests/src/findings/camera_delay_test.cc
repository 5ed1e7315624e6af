// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/camera_delay.h"

#include "fathom/base/random_stream.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;

// Two minutes along surge: poses whose stamps are late by `delay`, with noise of 2 mm, and u with
// noise of 1 cm/s.
Log Filmed(const std::function<double(double)>& place, double delay, std::uint64_t seed) {
  RandomStream noise(seed, "noise");
  Log log;
  log.pose = Stream{{}, {"x", "y", "z", "qx", "qy", "qz", "qw"}, {{}, {}, {}, {}, {}, {}, {}}};
  log.velocity = Stream{{}, {"u"}, {{}}};
  for (int k = 0; k < 2400; ++k) {
    const double t = 0.05 * k;
    log.pose->time.push_back(t + delay);
    const double row[] = {place(t) + 0.002 * noise.Normal(), 0.0, 0.0, 0.0, 0.0, 0.0, 1.0};
    for (std::size_t i = 0; i < 7; ++i) log.pose->values[i].push_back(row[i]);
    if (k % 2 != 0) continue;
    log.velocity->time.push_back(t);
    log.velocity->values[0].push_back((place(t + 1e-3) - place(t - 1e-3)) / 2e-3 +
                                      0.01 * noise.Normal());
  }
  return log;
}

// Tones of random phase that have no common period within reach.
std::function<double(double)> Wandering(std::uint64_t seed) {
  RandomStream random(seed, "phases");
  std::vector<double> phases;
  for (int i = 0; i < 5; ++i) phases.push_back(6.28 * random.Uniform());
  return [=](double t) {
    return 0.9 * std::sin(0.17 * t + phases[0]) + 0.4 * std::sin(0.31 * t + phases[1]) +
           0.2 * std::sin(0.73 * t + phases[2]) + 0.15 * std::sin(1.1 * t + phases[3]) +
           0.1 * std::sin(1.9 * t + phases[4]);
  };
}

class CameraDelays : public ::testing::TestWithParam<double> {};

TEST_P(CameraDelays, AreFound) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto found = FindCameraDelay(Filmed(Wandering(seed), GetParam(), seed));
    ASSERT_TRUE(found) << seed;
    EXPECT_NEAR(found->delay, GetParam(), 0.051) << seed;  // a step
  }
}

INSTANTIATE_TEST_SUITE_P(Seconds,
                         CameraDelays,
                         ::testing::Values(-8.0, -2.0, -0.25, 0.4, 3.0, 7.0));

TEST(CameraClock, DrawsTheCorrelationWithItsPeakAtTheDelay) {
  const auto curves = CameraDelayCurves(Filmed(Wandering(1), -2.0, 1));
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_EQ(curves[0].column, "u");
  const auto& [delay, correlation] = curves[0].curve;
  EXPECT_NEAR(delay.front(), -10.0, 1e-9);
  EXPECT_NEAR(delay.back(), 10.0, 1e-9);
  const auto best = std::ranges::max_element(correlation) - correlation.begin();
  EXPECT_NEAR(delay[static_cast<std::size_t>(best)], -2.0, 0.051);
  EXPECT_GT(correlation[static_cast<std::size_t>(best)], 0.95);
}

TEST(CameraClock, SaysNothingOfClocksThatAgree) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Log log = Filmed(Wandering(seed), 0.0, seed);
    const auto found = FindCameraDelay(log);
    EXPECT_FALSE(found && CheckCameraClock(log, *found)) << seed;
  }
}

// A period more or less is as good.
TEST(CameraClock, SaysNothingOfASine) {
  const auto sine = [](double t) { return std::sin(1.2 * t); };
  EXPECT_FALSE(FindCameraDelay(Filmed(sine, 2.0, 1)));
}

TEST(CameraClock, SaysNothingOfAnotherMotion) {
  Log log = Filmed(Wandering(1), 2.0, 1);
  log.velocity = Filmed(Wandering(9), 0.0, 2).velocity;
  const auto found = FindCameraDelay(log);
  EXPECT_FALSE(found) << found->delay;
}

TEST(CameraClock, WarnsOfMoreThanASecond) {
  const Log late = Filmed(Wandering(4), 2.0, 4);
  const auto finding = CheckCameraClock(late, *FindCameraDelay(late));
  ASSERT_TRUE(finding);
  EXPECT_EQ(finding->severity, Severity::kWarning);
  EXPECT_THAT(finding->sentence, HasSubstr("s after that of velocity.csv"));
  const Log early = Filmed(Wandering(4), -0.4, 4);
  const auto note = CheckCameraClock(early, *FindCameraDelay(early));
  ASSERT_TRUE(note);
  EXPECT_EQ(note->severity, Severity::kNote);
  EXPECT_THAT(note->sentence, HasSubstr("s before that of velocity.csv"));
}

}  // namespace
}  // namespace fathom
