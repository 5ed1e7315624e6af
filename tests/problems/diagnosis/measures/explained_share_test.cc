// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/measures/explained_share.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

// Noise of `std` over a slow error that is `before` times a sine of amplitude 1 with the first
// model and `after` times with the second: mean squares of before^2 / 2 and after^2 / 2.
struct Pair {
  std::vector<FreeRun> before, after;
};
Pair RunsOf(double std, double before, double after, std::size_t num_samples, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal(0.0, std);
  FreeRun a, b;
  for (std::size_t i = 0; i < num_samples; ++i) {
    const double t = 0.1 * static_cast<double>(i), noise = normal(generator);
    a.time.push_back(t);
    a.measured.push_back(noise + before * std::sin(0.3 * t));
    a.predicted.push_back(0.0);
    b.time.push_back(t);
    b.measured.push_back(noise + after * std::sin(0.3 * t));
    b.predicted.push_back(0.0);
  }
  return {{a}, {b}};
}

TEST(ExplainedShare, LeavesTheScatterOut) {
  const Pair runs = RunsOf(1.0, 2.0, 1.0, 20000, 1);
  const SourceRuns source = {runs.before, runs.after};
  // Slow errors of mean square 2 and 0.5; with the scatter it would be 1.5 / 3.
  EXPECT_NEAR(ExplainedShare({&source, 1}), 0.75, 0.03);
}

// Metres and metres per second: a source counts by its own noise, not by its unit.
TEST(ExplainedShare, WeighsEachSourceByItsOwnNoise) {
  const Pair speeds = RunsOf(0.01, 0.02, 0.0, 20000, 1);      // all of it removed
  const Pair places = RunsOf(100.0, 200.0, 200.0, 20000, 2);  // nothing of it
  const std::array sources = {SourceRuns{speeds.before, speeds.after},
                              SourceRuns{places.before, places.after}};
  EXPECT_NEAR(ExplainedShare(sources), 0.5, 0.03);
}

TEST(ExplainedShare, IsOneWhereNoiseIsNotAndNothingIsLeft) {
  const Pair runs = RunsOf(0.0, 2.0, 0.0, 1000, 1);
  const SourceRuns source = {runs.before, runs.after};
  EXPECT_NEAR(ExplainedShare({&source, 1}), 1.0, 1e-9);
}

TEST(ExplainedShare, IsNotKnownWhereNothingIsBeyondTheScatter) {
  const Pair runs = RunsOf(1.0, 0.01, 0.0, 20000, 1);
  const SourceRuns source = {runs.before, runs.after};
  EXPECT_TRUE(std::isnan(ExplainedShare({&source, 1})));
  EXPECT_TRUE(std::isnan(ExplainedShare({})));
}

}  // namespace
}  // namespace fathom
