// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/fit/search_data.h"

#include "fathom/diagnosis/fit/fit_with_noise.h"

#include <cmath>
#include <vector>

#include "surge_run.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

// What is searched of 400 s at 10 Hz, with so much noise [m/s].
std::vector<MeasuredSegment> SearchedUnder(double noise) {
  SurgeRun run;
  run.input = Square(60.0, 20.0);
  run.duration = 400.0;
  run.velocity_noise = noise;
  const std::vector<Log> logs = {LogOf(run, 1)};
  const TrainingData data(MeasuredSegmentsOf(logs, Dof::kSurge).all, kSurgeTruth, 100.0);
  std::vector<InitialState> initial;
  for (const MeasuredSegment& segment : data.segments()) initial.push_back(segment.initial);
  return SearchDataOf(data, FitBaseline(data, {kSurgeTruth, {}}, initial));
}

double StepOf(const MeasuredSegment& segment) {
  return segment.duration() / static_cast<double>(segment.stamps.velocity.size());
}

TEST(SearchDataOf, IsCoarseWhereTheNoiseHidesIt) {
  const std::vector<MeasuredSegment> searched = SearchedUnder(0.05);
  ASSERT_EQ(searched.size(), 1u);
  EXPECT_GT(StepOf(searched[0]), 0.15);
  EXPECT_GT(searched[0].inputs->steps.longest, 0.3);
}

TEST(SearchDataOf, IsFineWhereAnythingElseWouldBeSeen) {
  const std::vector<MeasuredSegment> searched = SearchedUnder(0.0001);
  ASSERT_EQ(searched.size(), 1u);
  EXPECT_NEAR(StepOf(searched[0]), 0.1, 0.01);
  EXPECT_EQ(searched[0].inputs->steps.longest, StepRules().longest);
}

}  // namespace
}  // namespace fathom
