// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/filters/moving_fit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

std::vector<double> SlowlyIrregularStamps(int n, double step, double start) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> jitter(0.4, 1.6);
  std::vector<double> time = {start};
  while (static_cast<int>(time.size()) < n) time.push_back(time.back() + step * jitter(generator));
  return time;
}

// The value at the stamp of a fit that has seen no other.
double Alone(const std::vector<double>& time,
             const std::vector<double>& values,
             const SavitzkyGolayOptions& options,
             size_t i,
             int derivative) {
  LocalPolynomial alone(time, options);
  EXPECT_TRUE(alone.MoveTo(i));
  return alone.Apply(alone.Weights(derivative), values);
}

TEST(MovingFit, IsTheLocalPolynomialOfEachColumn) {
  std::vector<double> time = SlowlyIrregularStamps(400, 0.02, 40.0);
  time.erase(time.begin() + 150, time.begin() + 190);  // a silence of more than half the window
  std::vector<double> fast, slow;
  for (const double t : time) {
    fast.push_back(std::sin(3.0 * t) + 0.1 * std::cos(41.0 * t));
    slow.push_back(7.0 - 0.3 * t + 0.02 * t * t);
  }
  for (const int order : {0, 1, 3, 4}) {
    const SavitzkyGolayOptions options = {.window = 0.9, .order = order};
    for (int d = 0; d <= order; ++d) {
      MovingFit fit(time, {fast, slow}, options);
      for (size_t i = 0; i < time.size(); ++i) {
        ASSERT_TRUE(fit.MoveTo(i, d));
        // Rounding of 1e-14 in values of order 10, raised by (2 / 0.9 s)^d d! and, at an end of the
        // data, by a factor of up to 30^d.
        const double tolerance = 1e-13 * std::pow(60.0, d);
        EXPECT_NEAR(fit.Estimate(0), Alone(time, fast, options, i, d), tolerance) << i << " " << d;
        EXPECT_NEAR(fit.Estimate(1), Alone(time, slow, options, i, d), tolerance) << i << " " << d;
      }
    }
  }
}

TEST(MovingFit, GoesToStampsInAnyOrder) {
  const std::vector<double> time = SlowlyIrregularStamps(80, 0.1, 0.0);
  std::vector<double> values;
  for (const double t : time) values.push_back(1.0 - 2.0 * t + 3.0 * t * t);
  MovingFit fit(time, {values}, {.window = 1.3, .order = 2});
  for (const size_t i : {79u, 3u, 40u, 41u, 0u, 78u, 12u, 12u}) {
    ASSERT_TRUE(fit.MoveTo(i, 1));
    EXPECT_NEAR(fit.Estimate(0), -2.0 + 6.0 * time[i], 1e-11) << i;
  }
}

// A displacement of kilometres in steps of millimetres, over hours: what comes into the sums and
// goes again leaves nothing behind.
TEST(MovingFit, KeepsItsDigitsOverALongLog) {
  std::vector<double> time, values;
  for (int i = 0; i < 300000; ++i) {
    time.push_back(0.02 * i);
    values.push_back(5000.0 + 0.8 * time.back() + 0.1 * std::sin(time.back()));
  }
  MovingFit fit(time, {values}, {.window = 0.5, .order = 3});
  double largest = 0.0;
  for (size_t i = 0; i < time.size(); ++i) {
    ASSERT_TRUE(fit.MoveTo(i, 1));
    largest = std::max(largest, std::abs(fit.Estimate(0) - 0.8 - 0.1 * std::cos(time[i])));
  }
  // A cubic about each stamp leaves 0.1 h^4 3/70 of a sine with h = 0.25 s (at an end some ten
  // times that), and values of 1e4 carry rounding of 1e-12, a slope over 0.5 s some 1e-11.
  EXPECT_LT(largest, 1e-4);
  ASSERT_TRUE(fit.MoveTo(200000, 1));
  EXPECT_NEAR(fit.Estimate(0), Alone(time, values, {.window = 0.5, .order = 3}, 200000, 1), 1e-10);
}

TEST(MovingFit, FailsWhereTheSamplesDoNotDetermineThePolynomial) {
  const std::vector<double> time = {0.0, 0.1, 0.2, 5.0, 5.1, 5.2, 5.3};
  const std::vector<double> values = {1.0, 2.0, 3.0, 1.0, 2.0, 4.0, 8.0};
  MovingFit fit(time, {values}, {.window = 1.0, .order = 3});
  for (size_t i = 0; i < 3; ++i) EXPECT_FALSE(fit.MoveTo(i, 0)) << i;
  for (size_t i = 3; i < 7; ++i) {
    ASSERT_TRUE(fit.MoveTo(i, 0)) << i;  // through all four
    EXPECT_NEAR(fit.Estimate(0), values[i], 1e-12);
  }
}

}  // namespace
}  // namespace fathom
