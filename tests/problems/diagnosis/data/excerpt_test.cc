// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/data/excerpt.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "surge_run.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

std::vector<MeasuredSegment> SegmentsLasting(const std::vector<double>& durations) {
  std::vector<Log> logs;
  for (const double duration : durations) {
    SurgeRun run;
    run.input = Multisine(40.0);
    run.duration = duration;
    run.name = "run_" + std::to_string(logs.size());
    logs.push_back(LogOf(run, 1));
  }
  return MeasuredSegmentsOf(logs, Dof::kSurge).all;
}

TEST(Excerpt, LeavesAloneWhatIsShortEnough) {
  const auto segments = SegmentsLasting({200.0, 100.0});
  const auto excerpt = Excerpt(segments, 300.1);
  ASSERT_EQ(excerpt.size(), 2U);
  EXPECT_EQ(excerpt[1].stamps.velocity, segments[1].stamps.velocity);
  EXPECT_EQ(excerpt[1].velocity, segments[1].velocity);
}

TEST(Excerpt, SpreadsPiecesEvenlyOverALongRun) {
  const auto segments = SegmentsLasting({3600.0});
  const auto pieces = Excerpt(segments, 900.0);
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_NEAR(DurationOf(pieces), 900.0, 1.0);
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    // In the middle of each third.
    EXPECT_NEAR(pieces[k].stamps.start, 1200.0 * static_cast<double>(k) + 450.0, 0.2);
    EXPECT_EQ(pieces[k].stamps.start, pieces[k].stamps.velocity.front());
    EXPECT_NEAR(pieces[k].duration(), 300.0, 0.2);
    EXPECT_EQ(pieces[k].velocity.size(), pieces[k].stamps.velocity.size());
    EXPECT_EQ(pieces[k].inputs, segments[0].inputs);  // of the whole log: thrusters remember
  }
}

TEST(Excerpt, TakesTheSameShareOfEveryLog) {
  const auto pieces = Excerpt(SegmentsLasting({2400.0, 600.0, 120.0}), 1560.0);
  std::map<std::string, double> durations;
  for (const MeasuredSegment& piece : pieces) durations[piece.log] += piece.duration();
  EXPECT_NEAR(durations["run_0"], 1200.0, 1.0);
  EXPECT_NEAR(durations["run_1"], 300.0, 0.5);
  EXPECT_NEAR(durations["run_2"], 60.0, 0.5);
}

}  // namespace
}  // namespace fathom
