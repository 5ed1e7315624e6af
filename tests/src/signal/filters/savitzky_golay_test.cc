// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/filters/savitzky_golay.h"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

std::vector<double> IrregularStamps(int n, double step, unsigned seed, double start = 0.0) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> jitter(0.4, 1.6);
  std::vector<double> time = {start};
  while (static_cast<int>(time.size()) < n) time.push_back(time.back() + step * jitter(generator));
  return time;
}

std::vector<double> EqualSteps(int n, double step) {
  std::vector<double> time(n);
  for (int i = 0; i < n; ++i) time[i] = step * i;
  return time;
}

// Derivative `d` of sum_k c_k t^k.
double Polynomial(const std::vector<double>& c, double t, int d) {
  double sum = 0.0;
  for (size_t k = d; k < c.size(); ++k) {
    double factor = c[k];
    for (int j = 0; j < d; ++j) factor *= static_cast<double>(k) - j;
    sum += factor * std::pow(t, static_cast<double>(k) - d);
  }
  return sum;
}

class SavitzkyGolayOrder : public ::testing::TestWithParam<int> {};

TEST_P(SavitzkyGolayOrder, IsExactOnPolynomialsOfItsOrderOnIrregularStamps) {
  const int order = GetParam();
  const std::vector<double> all = {0.7, -1.3, 0.9, 0.55, -0.41, 0.23, 0.17};
  const std::vector<double> c(all.begin(), all.begin() + order + 1);
  const std::vector<double> time = IrregularStamps(120, 0.02, 5, -1.2);
  std::vector<double> values;
  for (const double t : time) values.push_back(Polynomial(c, t, 0));
  for (int d = 0; d <= order; ++d) {
    const auto result = SavitzkyGolay(time, values, d, {.window = 0.5, .order = order});
    for (size_t i = 0; i < time.size(); ++i) {
      // Values of order 1 carry rounding 1e-16, which a derivative over half a window of 0.25 s
      // raises by d! / 0.25^d, and a window to one side by a further factor of some hundred.
      EXPECT_NEAR(result[i], Polynomial(c, time[i], d), 1e-13 * std::pow(20.0, d)) << d << " " << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Orders, SavitzkyGolayOrder, ::testing::Range(0, 7));

// Equal steps, whose windows share their weights, then a missing sample, another step, jitter and
// equal steps once more: each stamp as a fit that has seen no other.
TEST(SavitzkyGolay, GivesEachStampWhatItWouldGiveItAlone) {
  std::vector<double> time = EqualSteps(60, 0.02);
  time.erase(time.begin() + 30);
  for (int i = 0; i < 40; ++i) time.push_back(time.back() + 0.03);
  for (const double t : IrregularStamps(40, 0.02, 7, time.back() + 0.02)) time.push_back(t);
  for (int i = 0; i < 40; ++i) time.push_back(time.back() + 0.02);
  std::vector<double> values;
  for (const double t : time) values.push_back(std::sin(3.0 * t) + 0.1 * std::cos(41.0 * t));
  const SavitzkyGolayOptions options = {.window = 0.4, .order = 3};
  for (const int d : {0, 1}) {
    const auto result = SavitzkyGolay(time, values, d, options);
    for (size_t i = 0; i < time.size(); ++i) {
      LocalPolynomial alone(time, options);
      ASSERT_TRUE(alone.MoveTo(i));
      // Places differ by 1e-15 s at most, a share of 5e-15 of half a window.
      EXPECT_NEAR(result[i], alone.Apply(alone.Weights(d), values), 1e-12 * std::pow(20.0, d)) << i;
    }
  }
}

TEST(LocalPolynomial, GivesAllDerivativesInAnyOrder) {
  const std::vector<double> time = EqualSteps(50, 0.1);
  std::vector<double> values;
  for (const double t : time) values.push_back(1.0 - 2.0 * t + 3.0 * t * t);
  LocalPolynomial fit(time, {.window = 1.0, .order = 2});
  for (const size_t i : {20, 21, 21, 22, 0, 1, 49}) {
    ASSERT_TRUE(fit.MoveTo(i));
    for (const int d : {1, 0, 0, 2, 1}) {
      EXPECT_NEAR(
          fit.Apply(fit.Weights(d), values), Polynomial({1.0, -2.0, 3.0}, time[i], d), 1e-11)
          << i << " " << d;
    }
  }
}

// Numbers of scipy.signal.savgol_filter(y, 7, 3, deriv, delta=0.1), mode "interp".
TEST(SavitzkyGolay, AgreesWithScipyOnEqualSteps) {
  const std::vector<double> y = {0.3, -1.2, 2.5, 0.7, 1.9, -0.4, 3.1, 2.2, -1.7, 0.9, 1.1, 4.2};
  const std::vector<double> expected[3] = {{-0.3952380952380988,
                                            0.747619047619049,
                                            1.0476190476190501,
                                            0.9380952380952392,
                                            1.423809523809525,
                                            1.6333333333333349,
                                            1.4238095238095252,
                                            0.91904761904762,
                                            0.5571428571428576,
                                            -0.25952380952380016,
                                            0.6333333333333515,
                                            4.552380952380979},
                                           {17.087301587301656,
                                            6.49206349206352,
                                            0.23015873015873378,
                                            -1.6984126984126962,
                                            -3.9047619047619087,
                                            10.416666666666668,
                                            -3.76190476190476,
                                            -6.892857142857148,
                                            -12.32539682539683,
                                            -1.8134920634920393,
                                            21.86507936507945,
                                            58.71031746031765},
                                           {-127.61904761904812,
                                            -84.2857142857146,
                                            -40.95238095238109,
                                            2.380952380952385,
                                            -8.333333333333332,
                                            -22.380952380952383,
                                            -23.33333333333332,
                                            4.761904761904771,
                                            39.28571428571427,
                                            170.95238095238133,
                                            302.6190476190484,
                                            434.2857142857155}};
  const std::vector<double> time = EqualSteps(12, 0.1);
  for (int d = 0; d < 3; ++d) {
    const auto result = SavitzkyGolay(time, y, d, {.window = 0.65, .order = 3});
    for (size_t i = 0; i < y.size(); ++i) EXPECT_NEAR(result[i], expected[d][i], 1e-10) << d;
  }
}

TEST(SavitzkyGolay, KeepsItsAccuracyAtEpochStamps) {
  const std::vector<double> time = IrregularStamps(60, 0.1, 8, 1435138834.0);
  std::vector<double> values;
  for (const double t : time) values.push_back(0.3 * (t - 1435138834.0));
  const auto slope = SavitzkyGolay(time, values, 1, {.window = 1.05, .order = 3});
  for (const double s : slope) EXPECT_NEAR(s, 0.3, 1e-10);
}

// White noise of variance 1 leaves the smoothed value with 3 (3 m^2 - 7) / (4 m (m^2 - 4)) and the
// cubic's slope with S6 / (S2 S6 - S4^2) / step^2, S_k = sum of j^k over the m points.
TEST(SavitzkyGolay, HasTheClosedFormNoiseVariance) {
  const int half = 7, m = 2 * half + 1;
  const double step = 0.1;
  double s2 = 0.0, s4 = 0.0, s6 = 0.0;
  for (int j = -half; j <= half; ++j) {
    s2 += std::pow(j, 2);
    s4 += std::pow(j, 4);
    s6 += std::pow(j, 6);
  }
  const std::vector<double> time = EqualSteps(41, step);
  LocalPolynomial fit(time, {.window = (m - 0.5) * step, .order = 3});
  ASSERT_TRUE(fit.MoveTo(20));
  EXPECT_TRUE(fit.window().is_centred());
  ASSERT_EQ(fit.window().size(), static_cast<size_t>(m));
  const auto variance = [&](int d) {
    double sum = 0.0;
    for (const double w : fit.Weights(d)) sum += w * w;
    return sum;
  };
  EXPECT_NEAR(variance(0), 3.0 * (3.0 * m * m - 7.0) / (4.0 * m * (m * m - 4.0)), 1e-13);
  EXPECT_NEAR(variance(1), s6 / (s2 * s6 - s4 * s4) / (step * step), 1e-11);
  ASSERT_TRUE(fit.MoveTo(0));
  EXPECT_FALSE(fit.window().is_centred());
  EXPECT_EQ(fit.window().size(), static_cast<size_t>(m)) << "shifted, not cut";
}

TEST(SavitzkyGolay, NeverBridgesASilence) {
  std::vector<double> time = EqualSteps(50, 0.1), values(50, 3.0);
  for (int i = 0; i < 50; ++i) {
    time.push_back(time[49] + 1.01 + 0.1 * i);
    values.push_back(-8.0);
  }
  for (const int d : {0, 1}) {
    const auto result = SavitzkyGolay(time, values, d, {.window = 1.0, .order = 3});
    for (size_t i = 0; i < 100; ++i) {
      EXPECT_NEAR(result[i], d == 1 ? 0.0 : values[i], 1e-11) << i;
    }
  }
}

TEST(SavitzkyGolay, IsNotANumberWhereThereIsTooLittle) {
  // Four samples, a silence, three samples.
  const std::vector<double> time = {0.0, 0.1, 0.2, 0.3, 5.0, 5.1, 5.2};
  const std::vector<double> values = {1.0, 2.0, 0.5, 0.1, 7.0, 7.0, 7.0};
  const auto result = SavitzkyGolay(time, values, 0, {.window = 1.0, .order = 3});
  for (size_t i = 0; i < 4; ++i) EXPECT_NEAR(result[i], values[i], 1e-10);
  for (size_t i = 4; i < 7; ++i) EXPECT_TRUE(std::isnan(result[i])) << i;
}

// Five samples within 0.1 ms say nothing about a slope over a second.
TEST(SavitzkyGolay, IsNotANumberWhereTheSamplesAreIllPlaced) {
  std::vector<double> time, values;
  for (int i = 0; i < 5; ++i) {
    time.push_back(2e-5 * i);
    values.push_back(i % 2);
  }
  for (const double slope : SavitzkyGolay(time, values, 1, {.window = 1.0, .order = 3})) {
    EXPECT_TRUE(std::isnan(slope));
  }
}

TEST(LocalPolynomial, DoesNotDependOnTheOrderInWhichStampsAreVisited) {
  const std::vector<double> time = IrregularStamps(80, 0.1, 2);
  std::vector<double> values;
  for (const double t : time) values.push_back(std::sin(3.0 * t));
  const SavitzkyGolayOptions options = {.window = 1.3, .order = 2};
  std::vector<double> expected;
  LocalPolynomial fit(time, options);
  for (size_t i = 0; i < time.size(); ++i) {
    ASSERT_TRUE(fit.MoveTo(i));
    expected.push_back(fit.Apply(fit.Weights(1), values));
  }
  for (const size_t i : {79u, 3u, 40u, 41u, 0u, 78u, 12u}) {
    ASSERT_TRUE(fit.MoveTo(i));
    EXPECT_DOUBLE_EQ(fit.Apply(fit.Weights(1), values), expected[i]) << i;
  }
}

std::vector<double> NoisySine(const std::vector<double>& time, double period, double noise) {
  std::mt19937 generator(4);
  std::normal_distribution<double> normal;
  std::vector<double> values;
  for (const double t : time)
    values.push_back(std::sin(2.0 * M_PI / period * t) + noise * normal(generator));
  return values;
}

TEST(ChooseWindow, IsShortForCleanDataAndLongForNoisyOnes) {
  const std::vector<double> time = IrregularStamps(3000, 0.1, 6);
  const double clean = ChooseWindow(time, NoisySine(time, 20.0, 1e-6), 3, 1.05, 20.0);
  const double noisy = ChooseWindow(time, NoisySine(time, 20.0, 0.1), 3, 1.05, 20.0);
  EXPECT_LE(clean, 1.5);
  EXPECT_GE(noisy, 4.0);
}

// A window of half the motion's period takes a quarter off the velocity. The chosen one must not.
TEST(ChooseWindow, KeepsTheAmplitudeOfTheMotion) {
  for (const double period : {6.0, 20.0}) {
    const std::vector<double> time = EqualSteps(3000, 0.1);
    const double window = ChooseWindow(time, NoisySine(time, period, 0.05), 3, 1.05, 20.0);
    const auto slope =
        SavitzkyGolay(time, NoisySine(time, period, 0.0), 1, {.window = window, .order = 3});
    double sum = 0.0;
    for (size_t i = 300; i < 2700; ++i) sum += slope[i] * slope[i];
    const double amplitude = std::sqrt(2.0 * sum / 2400.0);
    EXPECT_NEAR(amplitude * period / (2.0 * M_PI), 1.0, 0.02) << period << " s, window " << window;
  }
}

// Noise that neighbours share must not be taken for motion.
TEST(ChooseWindow, IsNotFooledByNoiseThatNeighboursShare) {
  std::mt19937 generator(9);
  std::normal_distribution<double> normal;
  const std::vector<double> time = EqualSteps(3000, 0.1);
  std::vector<double> values = NoisySine(time, 20.0, 0.0);
  double e = 0.0;
  for (double& value : values) {
    e = 0.5 * e + 0.1 * normal(generator);
    value += e;
  }
  EXPECT_GE(ChooseWindow(time, values, 3, 1.05, 20.0), 4.0);
}

}  // namespace
}  // namespace fathom
