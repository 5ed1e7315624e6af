// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/convert/samples.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;

TEST(Samples, OfTwoChannelsOfCommandsHoldUntilTheNextOfTheirOwn) {
  // 50 ms apart.
  const ChannelSamples port = {"port", {0.0, 0.1, 0.2}, {{1, 2, 3}}};
  const ChannelSamples starboard = {"starboard", {0.05, 0.15, 0.25}, {{10, 20, 30}}};
  const ChannelSamples held = Held({port, starboard});
  EXPECT_THAT(held.time, ElementsAre(0.05, 0.1, 0.15, 0.2, 0.25));
  EXPECT_THAT(held.values[0], ElementsAre(1, 2, 2, 3, 3));
  EXPECT_THAT(held.values[1], ElementsAre(10, 10, 20, 20, 30));
  EXPECT_EQ(held.channel, "port and starboard");
}

// The channel with few samples does not thin out the other, nor are there ramps.
TEST(Samples, OfACommandThatIsWrittenOnChangeHoldUntilTheChange) {
  const ChannelSamples port = {"port", {0, 1, 2, 3, 4, 5}, {{0, 1, 2, 3, 4, 5}}};
  const ChannelSamples starboard = {"starboard", {1, 4}, {{10, 20}}};
  const ChannelSamples held = Held({port, starboard});
  EXPECT_THAT(held.time, ElementsAre(1, 2, 3, 4, 5));
  EXPECT_THAT(held.values[0], ElementsAre(1, 2, 3, 4, 5));
  EXPECT_THAT(held.values[1], ElementsAre(10, 10, 10, 20, 20));
}

TEST(Samples, OfACommandThatFallsSilentHoldToTheEnd) {
  const ChannelSamples port = {"port", {0, 1, 2, 3, 60}, {{0, 1, 2, 3, 4}}};
  const ChannelSamples starboard = {"starboard", {0, 1}, {{10, 20}}};
  const ChannelSamples held = Held({port, starboard});
  EXPECT_THAT(held.time, ElementsAre(0, 1, 2, 3, 60));
  EXPECT_THAT(held.values[1], ElementsAre(10, 20, 20, 20, 20));
}

// Topics that are written one after the other, within 2 % of a step: one row each time.
TEST(Samples, OfOneCycleAreOneRowOfACommand) {
  const ChannelSamples port = {"port", {0.0, 0.1, 0.2}, {{1, 2, 3}}};
  const ChannelSamples starboard = {"starboard", {0.001, 0.101, 0.201}, {{10, 20, 30}}};
  const ChannelSamples held = Held({port, starboard});
  EXPECT_THAT(held.time, ElementsAre(0.001, 0.101, 0.201));
  EXPECT_THAT(held.values[0], ElementsAre(1, 2, 3));
  EXPECT_THAT(held.values[1], ElementsAre(10, 20, 30));
}

TEST(Samples, OfAChannelWithoutAnyHoldNothing) {
  EXPECT_TRUE(Held({{"port", {0.0, 0.1}, {{1, 2}}}, {"starboard", {}, {{}}}}).time.empty());
}

// A turn about z by 60 degrees within a step, whose second quaternion has the other sign: half way
// it is one by 30 degrees. On straight lines it would be a quaternion of length 0.26.
TEST(Samples, OfAttitudesLieOnTheGreatCircle) {
  const double half = std::acos(-1.0) / 6.0;
  ChannelSamples attitude = {
      "attitude", {0.0, 1.0}, {{0, 0}, {0, 0}, {0, -std::sin(half)}, {1, -std::cos(half)}}};
  attitude.quaternion = {{0, 1, 2, 3}};
  const auto between = InterpolatedAt(attitude, {0.5}, 2.0);
  const double expected[] = {0, 0, std::sin(half / 2.0), std::cos(half / 2.0)};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(between[i][0], expected[i], 1e-12);
}

// What is no quaternion does not become one.
TEST(Samples, OfAttitudesKeepTheirLength) {
  ChannelSamples attitude = {"attitude", {0.0, 1.0}, {{0, 0}, {0, 0}, {0, 0}, {0.5, 0.7}}};
  attitude.quaternion = {{0, 1, 2, 3}};
  EXPECT_NEAR(InterpolatedAt(attitude, {0.5}, 2.0)[3][0], 0.6, 1e-12);
}

}  // namespace
}  // namespace fathom
