// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/adaptive/adaptive_follower.h"

#include "fathom/adaptive/fit_adaptive.h"

#include <cmath>
#include <vector>

#include "experiments.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

// docs/adaptive.md (3) with a period of 21 s, 37 N and 0.15 m/s.
const AdaptiveOptions kFollowed = {.gains = AdaptiveGains{-0.0997, {1.09e-5, 19.6, 0.663, 0.0149}}};

FollowedEstimate FollowAll(const std::vector<Segment>& segments, AdaptiveFollower* follower) {
  FollowedEstimate last;
  for (const Segment& segment : segments) {
    for (size_t i = 0; i < segment.time.size(); ++i) {
      last = follower->Add(segment.time[i], segment.command.value[i], segment.velocity[i]);
    }
  }
  return last;
}

Segment ShiftedBy(double seconds, Segment segment) {
  for (double& t : segment.time) t += seconds;
  for (double& t : segment.command.time) t += seconds;
  return segment;
}

// Both segments share the stamps of command and motion, so no force changes between two samples.
TEST(AdaptiveFollower, EndsAtTheNumbersOfTheBatch) {
  const Segment first = RunOf(FlatFishSurge(), 1);
  const double gap = first.time.back() + 30.5;  // [s]: a silence that starts a segment
  const std::vector<Segment> segments = {first, ShiftedBy(gap, RunOf(FlatFishSurge(), 2))};
  const AdaptiveSummary batch = FitAdaptive(segments, kFollowed);
  ASSERT_TRUE(batch.IsUsable()) << batch.message;
  AdaptiveFollower follower(kFollowed);
  const FollowedEstimate last = FollowAll(segments, &follower);
  EXPECT_TRUE(last.usable);
  EXPECT_EQ(ToVector(last.model), ToVector(batch.model));
  // 6002 samples in blocks of 16: the third begins at most 8 samples beside its place, of 2001.
  for (int k = 0; k < kNumParameters; ++k) {
    const double std = std::sqrt(batch.covariance(k, k));
    EXPECT_NEAR(last.std[k], std, 0.01 * std) << k;
  }
}

TEST(AdaptiveFollower, GoesOnFromItsStateToTheLastDigit) {
  const Segment segment = RunOf(FlatFishSurge(), 3);
  AdaptiveFollower whole(kFollowed), first(kFollowed);
  for (size_t i = 0; i < 1000; ++i) {
    for (AdaptiveFollower* follower : {&whole, &first}) {
      follower->Add(segment.time[i], segment.command.value[i], segment.velocity[i]);
    }
  }
  AdaptiveFollower second(kFollowed, first.state(), first.scatter());
  for (size_t i = 1000; i < segment.time.size(); ++i) {
    const auto a = whole.Add(segment.time[i], segment.command.value[i], segment.velocity[i]);
    const auto b = second.Add(segment.time[i], segment.command.value[i], segment.velocity[i]);
    ASSERT_EQ(ToVector(a.model), ToVector(b.model)) << i;
    ASSERT_EQ(a.std, b.std) << i;
  }
}

TEST(AdaptiveFollower, GivesNoIntervalBehindFewerThanTenSamples) {
  const Segment segment = RunOf(FlatFishSurge(), 4);
  AdaptiveFollower follower(kFollowed);
  for (size_t i = 0; i < 10; ++i) {
    const auto estimate =
        follower.Add(segment.time[i], segment.command.value[i], segment.velocity[i]);
    EXPECT_TRUE(std::isfinite(estimate.model.inertia));
    EXPECT_EQ(std::isnan(estimate.std[kInertia]), i < 9) << i;
    EXPECT_FALSE(estimate.usable) << "the law has hardly begun";
  }
}

// Gains of 1e12 with steps of a second: the state leaves the finite numbers.
TEST(AdaptiveFollower, SaysThatTheLawDiverged) {
  AdaptiveFollower follower({.gains = AdaptiveGains{-1e12, {1e12, 1e12, 1e12, 1e12}}});
  FollowedEstimate last;
  for (int i = 0; i < 100; ++i) last = follower.Add(i, 5.0, 0.1 * (i % 3));
  EXPECT_FALSE(follower.IsFinite());
  EXPECT_FALSE(last.usable);
  EXPECT_TRUE(std::isnan(last.model.inertia));
  EXPECT_TRUE(std::isnan(last.std[kInertia]));
}

}  // namespace
}  // namespace fathom
