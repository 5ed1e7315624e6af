// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/data/uneven_noise.h"

#include "fathom/base/random_stream.h"
#include "fathom/diagnosis/data/bins.h"
#include "fathom/diagnosis/fit/outliers.h"

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

constexpr int kNumSamples = 3000;
constexpr double kNoise = 0.002;  // usual [m]

struct Way {
  std::vector<double> time, value;
};

// 300 s to and fro by 5 m at 10 Hz, with noise of this multiple of the usual.
Way WayWith(const std::function<double(int)>& multiple, unsigned seed) {
  Way way;
  RandomStream random(seed, "test");
  for (int i = 0; i < kNumSamples; ++i) {
    const double t = 0.1 * i;
    way.time.push_back(t);
    way.value.push_back(2.5 * std::sin(0.25 * t) + kNoise * multiple(i) * random.Normal());
  }
  return way;
}

// A quarter of the usual, the usual, eight times the usual.
double Thirds(int i) { return i < kNumSamples / 3 ? 0.25 : i < 2 * kNumSamples / 3 ? 1.0 : 8.0; }

TEST(VarianceOverUsual, IsEmptyWhereTheNoiseIsEven) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    Way way = WayWith([](int) { return 1.0; }, seed);
    EXPECT_TRUE(VarianceOverUsual(way.time, way.value).empty()) << seed;
    for (double& value : way.value) value = kNoise * std::round(value / kNoise);  // coarse steps
    EXPECT_TRUE(VarianceOverUsual(way.time, way.value).empty()) << seed;
  }
}

// To an octave, but where one passes into the other; whatever jumps there are, and gaps.
TEST(VarianceOverUsual, FollowsNoiseThatChanges) {
  Way way = WayWith(Thirds, 1);
  for (int i = 700; i < kNumSamples; ++i) {
    way.value[i] += 0.5;
    way.time[i] += 20.0;
  }
  way.value[300] += 1.0;
  const std::vector<double> variance = VarianceOverUsual(way.time, way.value);
  ASSERT_EQ(variance.size(), way.value.size());
  int num_off = 0, num_looked_at = 0;
  for (int i = 0; i < kNumSamples; ++i) {
    if (std::abs(i % 1000 - 500) > 465) continue;
    ++num_looked_at;
    num_off += std::abs(std::log2(variance[i]) - 2.0 * std::log2(Thirds(i))) > 1.01;
  }
  EXPECT_LT(num_off, num_looked_at / 50);
}

TEST(VarianceOverUsual, NeedsSamplesToChangeOver) {
  Way way = WayWith(Thirds, 1);
  way.time.resize(250);
  way.value.resize(250);
  EXPECT_TRUE(VarianceOverUsual(way.time, way.value).empty());
  EXPECT_TRUE(VarianceOverUsual({}, {}).empty());
}

// A vehicle at rest, whose poses become ten times as noisy halfway.
MeasuredSegment AtRest() {
  auto inputs = std::make_shared<EffectInputs>();
  inputs->command = {{0.0}, {0.0}};
  MeasuredSegment segment;
  segment.inputs = inputs;
  RandomStream random(1, "test");
  for (int i = 0; i < kNumSamples; ++i) {
    const bool is_late = i >= kNumSamples / 2;
    segment.stamps.displacement.push_back(0.1 * i);
    segment.displacement.push_back((is_late ? 10.0 : 1.0) * kNoise * random.Normal());
    segment.displacement_variance.push_back(is_late ? 64.0 : 1.0);
  }
  return segment;
}

TEST(UnevenNoise, WeighsInTheBins) {
  const std::vector<MeasuredSegment> segments = {AtRest()};
  const Bins bins(segments);
  for (int i = 0; i + 1 < bins.size(); ++i) {  // the last may hold fewer samples
    EXPECT_EQ(bins.samples()[i].variance_factor, bins.samples()[i].time < 149.9 ? 1.0 : 64.0) << i;
  }
}

// Six standard deviations are ten times as far where the noise is ten times as large.
TEST(UnevenNoise, SaysWhatAWildSampleIs) {
  std::vector<MeasuredSegment> segments = {AtRest()};
  segments[0].displacement[100] += 20.0 * kNoise;
  segments[0].displacement[2500] = 20.0 * kNoise;
  EXPECT_EQ(RemoveOutliers({{890.0, 60.0, 39.0, 0.0}, {}}, {{0.0, 0.0}}, &segments), 1);
  EXPECT_EQ(segments[0].displacement.size(), segments[0].displacement_variance.size());
  EXPECT_EQ(segments[0].stamps.displacement[100], 0.1 * 101);
}

}  // namespace
}  // namespace fathom
