// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/twist_scale.h"

#include "fathom/base/random_stream.h"
#include "fathom/log/log.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

struct DrawnSurge {
  Log log;
  double factor = 0.0;  // of u over the truth
};

// Two minutes at 10 Hz of a surge of six sines, seen by noisy poses and by a noisy u that is too
// large or too small: the noise of each, smoothed, is about a tenth of the motion.
DrawnSurge Draw(int seed) {
  RandomStream random(static_cast<std::uint64_t>(seed), "drawn surge");
  DrawnSurge drawn;
  drawn.factor = 0.5 + 1.5 * random.Uniform();
  double speed[6], rate[6], phase[6];
  for (int k = 0; k < 6; ++k) {
    speed[k] = 0.1 * (1.0 + random.Uniform());
    rate[k] = 0.1 + 1.1 * random.Uniform();
    phase[k] = 6.28 * random.Uniform();
  }
  drawn.log.pose = Stream{{}, {"x", "y", "z", "qx", "qy", "qz", "qw"}, {}};
  drawn.log.pose->values.resize(7);
  drawn.log.velocity = Stream{{}, {"u"}, {{}}};
  for (int i = 0; i < 1200; ++i) {
    const double t = 0.1 * i;
    double x = 0.0, u = 0.0;
    for (int k = 0; k < 6; ++k) {
      x += speed[k] / rate[k] * std::sin(rate[k] * t + phase[k]);
      u += speed[k] * std::cos(rate[k] * t + phase[k]);
    }
    const double row[] = {x + 0.03 * random.Normal(), 0.0, 0.0, 0.0, 0.0, 0.0, 1.0};
    drawn.log.pose->time.push_back(t);
    for (int k = 0; k < 7; ++k) drawn.log.pose->values[k].push_back(row[k]);
    drawn.log.velocity->time.push_back(t);
    drawn.log.velocity->values[0].push_back(drawn.factor * (u + 0.1 * random.Normal()));
  }
  return drawn;
}

// 95 % of 400: a standard deviation of 1.1 %.
TEST(TwistScale, IntervalHoldsTheFactorAsOftenAsItSays) {
  constexpr int kRuns = 400;
  int held = 0;
  for (int seed = 0; seed < kRuns; ++seed) {
    const DrawnSurge drawn = Draw(seed);
    const auto motions = TwinMotionsOf(drawn.log);
    ASSERT_EQ(motions.size(), 1U);
    const TwistScale scale = TwistScaleOf(motions[0], 0.0);
    held += std::abs(scale.factor - drawn.factor) <= scale.half_width ? 1 : 0;
    EXPECT_LT(scale.half_width, 0.1 * drawn.factor) << seed;
  }
  RecordProperty("held", held);
  EXPECT_GE(held, kRuns * 92 / 100);
  EXPECT_LE(held, kRuns * 98 / 100);
}

TEST(TwistScale, IsToldWithItsInterval) {
  EXPECT_EQ(FormatTwistScale({-0.98, 0.02}), "-0.98 (-1 to -0.96)");
  EXPECT_EQ(FormatTwistScale({100.3, 0.52}), "100 (99.8 to 101)");
}

// A motion of one period: a lag of a quarter period tells nothing, another one is taken.
TEST(TwistScale, FindsAnInstrumentOfAPeriodicMotion) {
  std::vector<double> time, values;
  for (int i = 0; i < 600; ++i) {
    time.push_back(0.1 * i);
    values.push_back(std::sin(2.0 * M_PI / 5.0 * time.back()));
  }
  const std::vector<double> instrument = InstrumentOf(time, values, 1.0);
  double product = 0.0;
  for (std::size_t i = 100; i < 500; ++i) product += instrument[i] * values[i];
  EXPECT_GT(std::abs(product), 100.0);
}

}  // namespace
}  // namespace fathom
