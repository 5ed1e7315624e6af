// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/fit/outliers.h"

#include "fathom/base/random_stream.h"

#include <memory>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

constexpr int kNumOutlierSamples = 2000;
constexpr double kOutlierNoise = 0.01;  // [m/s]

// A vehicle at rest without a command: all that is measured is noise.
std::vector<MeasuredSegment> SegmentsAtRest() {
  auto inputs = std::make_shared<EffectInputs>();
  inputs->command = {{0.0}, {0.0}};
  MeasuredSegment segment;
  segment.inputs = inputs;
  RandomStream random(1, "test");
  for (int i = 0; i < kNumOutlierSamples; ++i) {
    segment.stamps.velocity.push_back(0.1 * i);
    segment.velocity.push_back(kOutlierNoise * random.Normal());
  }
  return {segment};
}

int Remove(std::vector<MeasuredSegment>* segments) {
  return RemoveOutliers({{890.0, 60.0, 39.0, 0.0}, {}}, {{0.0, 0.0}}, segments);
}

// Beyond six robust standard deviations lie 2e-9 of Gaussian noise; the median of eleven moves the
// limit by a third of one: 1e-8 of 2000 samples.
TEST(RemoveOutliers, LeavesGaussianNoiseAlone) {
  auto segments = SegmentsAtRest();
  EXPECT_EQ(Remove(&segments), 0);
  EXPECT_EQ(segments[0].velocity.size(), kNumOutlierSamples);
}

TEST(RemoveOutliers, TakesOutWildSamplesAndNoOthers) {
  auto segments = SegmentsAtRest();
  const std::set<int> wild = {0, 17, 300, 301, 1500, kNumOutlierSamples - 1};
  for (const int i : wild) segments[0].velocity[i] += i % 2 == 0 ? 0.15 : -0.15;
  const auto before = segments[0];
  EXPECT_EQ(Remove(&segments), static_cast<int>(wild.size()));
  int k = 0;
  for (int i = 0; i < kNumOutlierSamples; ++i) {
    if (wild.count(i) > 0) continue;
    ASSERT_EQ(segments[0].stamps.velocity[k], before.stamps.velocity[i]);
    ASSERT_EQ(segments[0].velocity[k++], before.velocity[i]);
  }
  EXPECT_EQ(static_cast<size_t>(k), segments[0].velocity.size());
}

// What a cause leaves is structure, not outliers: a jump that stays, a slow swing.
TEST(RemoveOutliers, LeavesStructureAlone) {
  auto segments = SegmentsAtRest();
  for (int i = 0; i < kNumOutlierSamples; ++i) {
    if (i > 700) segments[0].velocity[i] += 0.3;
    segments[0].velocity[i] += 0.2 * std::sin(0.3 * 0.1 * i);
  }
  EXPECT_EQ(Remove(&segments), 0);
}

TEST(RemoveOutliers, LeavesSegmentsShorterThanTheNeighbourhoodAlone) {
  auto segments = SegmentsAtRest();
  segments[0].velocity.resize(10);
  segments[0].stamps.velocity.resize(10);
  segments[0].velocity[4] = 5.0;
  EXPECT_EQ(Remove(&segments), 0);
}

}  // namespace
}  // namespace fathom
