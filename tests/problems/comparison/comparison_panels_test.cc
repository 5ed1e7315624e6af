// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/comparison/comparison_panels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "handmade_comparison.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(ResponsePanel, PutsAGapAfterEachSegmentInTheOrderOfTime) {
  const TimePanel panel =
      ResponsePanel(HandmadeDof({HandmadeRow(Family::kOutputError, 0.02, 0.03)}));
  // 31 samples from 0 s, 21 held out from 4 s, 21 from 50 s, and a gap after each.
  ASSERT_EQ(panel.time.size(), 31u + 21u + 21u + 3u);
  EXPECT_DOUBLE_EQ(panel.time[0], 0.0);
  EXPECT_NEAR(panel.time[30], 3.0, 1e-9);
  EXPECT_NEAR(panel.time[32], 4.0, 1e-9);
  EXPECT_NEAR(panel.time[54], 50.0, 1e-9);
  EXPECT_TRUE(std::is_sorted(panel.time.begin(), panel.time.end()));

  ASSERT_TRUE(panel.measured.has_value());
  ASSERT_EQ(panel.responses.size(), 1u);
  for (const Series* series : {&*panel.measured, &panel.responses[0]}) {
    ASSERT_EQ(series->values.size(), panel.time.size()) << series->name;
    for (size_t i = 0; i < panel.time.size(); ++i) {
      const bool is_gap = i == 31 || i == 53 || i == 75;
      EXPECT_EQ(std::isnan(series->values[i]), is_gap) << series->name << " at " << i;
    }
  }
  ASSERT_EQ(panel.held_out.size(), 1u);
  EXPECT_NEAR(panel.held_out[0].from, 4.0, 1e-9);
  EXPECT_NEAR(panel.held_out[0].to, 6.0, 1e-9);
}

TEST(ResponsePanel, ShowsTheFreeRunOfEachModel) {
  const TimePanel panel =
      ResponsePanel(HandmadeDof({HandmadeRow(Family::kOutputError, 0.02, 0.03)}));
  // Under no force the buoyancy of -0.5 N drives it: m dv/dt = 0.5 - 5 v - 30 v|v|. The run starts
  // where it fits the first two seconds at rest best: it goes through 0.
  const std::vector<double>& v = panel.responses[0].values;
  const double slope = (0.5 - 5.0 * v[0] - 30.0 * v[0] * std::abs(v[0])) / 40.0;
  EXPECT_NEAR(v[1], v[0] + 0.1 * slope, 2e-5);
  EXPECT_NEAR(std::accumulate(v.begin(), v.begin() + 21, 0.0) / 21.0, 0.0, 1e-3);
  EXPECT_EQ(panel.responses[0].note, "held-out velocity NMAE 0.030");
}

TEST(ResponsePanel, SaysThatARunDivergesInPlaceOfItsFigure) {
  const TimePanel panel =
      ResponsePanel(HandmadeDof({HandmadeRow(Family::kOutputError, 0.02, NAN)}));
  EXPECT_EQ(panel.responses[0].note, "held-out velocity diverges");
}

TEST(CommandPanel, HoldsTheCommandOverTheTimeOfTheMotion) {
  DofComparison comparison = HandmadeDof({HandmadeRow(Family::kOutputError, 0.02, 0.03)});
  for (Segment& segment : comparison.scored.train) {
    const double start = segment.time.front();
    segment.command = {{start, start + 1.0}, {5.0, -7.0}};
  }
  const TimePanel motion = ResponsePanel(comparison), command = CommandPanel(comparison);
  EXPECT_EQ(command.quantity, "force");
  EXPECT_EQ(command.unit, "N");
  EXPECT_TRUE(command.is_stepped);
  EXPECT_EQ(command.time.front(), motion.time.front());
  EXPECT_EQ(command.time.back(), motion.time.back());
  EXPECT_EQ(command.responses.at(0).values.at(0), 5.0);
  EXPECT_EQ(command.responses.at(0).values.at(1), -7.0);
  ASSERT_EQ(command.held_out.size(), 1u);
  EXPECT_EQ(command.held_out[0].from, motion.held_out.at(0).from);
}

TEST(ResponsePanel, FadesAllModelsButTheRecommendedOne) {
  const TimePanel panel =
      ResponsePanel(HandmadeDof({HandmadeRow(Family::kLeastSquares, 0.02, 0.09),
                                 HandmadeRow(Family::kOutputError, 0.02, 0.03)}));
  ASSERT_EQ(panel.responses.size(), 2u);
  EXPECT_TRUE(panel.responses[0].is_faded);
  EXPECT_FALSE(panel.responses[1].is_faded);
}

TEST(ResponsePanel, LeavesOutModelsThatAreNotUsable) {
  const TimePanel panel = ResponsePanel(HandmadeDof({UnusableRow(Family::kLeastSquares)}));
  EXPECT_TRUE(panel.responses.empty());
}

TEST(ParameterPanels, HoldEachUsableModelsValueAndDeviation) {
  const auto panels = ParameterPanels(HandmadeDof(
      {UnusableRow(Family::kLeastSquares), HandmadeRow(Family::kOutputError, 0.02, 0.03)}));
  ASSERT_EQ(panels.size(), 4u);
  EXPECT_EQ(panels[2].name, "linear damping");
  EXPECT_EQ(panels[2].unit, "kg/s");
  ASSERT_EQ(panels[2].estimates.size(), 1u);
  EXPECT_EQ(panels[2].estimates[0].name, "Output error, velocity.csv");
  EXPECT_EQ(panels[2].estimates[0].value, 5.0);
  EXPECT_DOUBLE_EQ(panels[2].estimates[0].std, 0.5);
}

}  // namespace
}  // namespace fathom
