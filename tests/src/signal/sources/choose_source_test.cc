// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/sources/choose_source.h"

#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Log WithBothSources() {
  Log log;
  log.velocity = {.time = {0.0}, .columns = {"u"}, .values = {{0.1}}};
  log.pose = Stream{.time = {}, .columns = {"x", "y", "z", "qx", "qy", "qz", "qw"}, .values = {}};
  log.pose->values.resize(7);
  return log;
}

TEST(SourcesOf, PutsTheVelocityBeforeThePoses) {
  Log log = WithBothSources();
  EXPECT_THAT(SourcesOf(log, Dof::kSurge), ElementsAre(Source::kPoseEstimator, Source::kCamera));
  EXPECT_THAT(SourcesOf(log, Dof::kHeave), ElementsAre(Source::kCamera));
  log.pose.reset();
  EXPECT_THAT(SourcesOf(log, Dof::kHeave), IsEmpty());
}

TEST(BestSourceOf, IsTheVelocityThatWillBeMissedWhereNothingMeasures) {
  EXPECT_EQ(BestSourceOf(WithBothSources(), Dof::kHeave), Source::kCamera);
  EXPECT_EQ(BestSourceOf(Log(), Dof::kHeave), Source::kPoseEstimator);
}

TEST(WithSourceOnly, LeavesTheOtherSourceOut) {
  const Log camera = WithSourceOnly(WithBothSources(), Source::kCamera);
  EXPECT_TRUE(camera.pose);
  EXPECT_FALSE(camera.velocity);
  const Log estimator = WithSourceOnly(WithBothSources(), Source::kPoseEstimator);
  EXPECT_FALSE(estimator.pose);
  EXPECT_TRUE(estimator.velocity);
}

TEST(WithSourceOnly, LeavesALogWithoutThatSourceAsItIs) {
  Log log = WithBothSources();
  log.pose.reset();
  EXPECT_TRUE(WithSourceOnly(log, Source::kCamera).velocity);
}

}  // namespace
}  // namespace fathom
