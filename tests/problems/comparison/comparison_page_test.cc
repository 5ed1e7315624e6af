// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/comparison/comparison_page.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "handmade_comparison.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// Two seconds of held-out data tell none of these leads from chance: recommendation_test.cc.
TEST(ParameterTable, MarksTheRowToTake) {
  const Table table = ParameterTable(HandmadeDof({HandmadeRow(Family::kLeastSquares, 0.01, 0.09),
                                                  HandmadeRow(Family::kAdaptive, 0.03, 0.05),
                                                  HandmadeRow(Family::kOutputError, 0.02, 0.07)}));
  ASSERT_EQ(table.rows.size(), 3u);
  EXPECT_EQ(table.rows[0].flag, RowFlag::kNone);
  EXPECT_EQ(table.rows[1].flag, RowFlag::kNone);
  EXPECT_EQ(table.rows[2].flag, RowFlag::kBest);
}

TEST(ParameterTable, GoesByTheTrainingDataWhereNoneAreHeldOut) {
  DofComparison comparison = HandmadeDof(
      {HandmadeRow(Family::kLeastSquares, 0.01, kNan), HandmadeRow(Family::kAdaptive, 0.03, kNan)});
  comparison.scored.held_out.clear();
  const Table table = ParameterTable(comparison);
  EXPECT_EQ(table.rows[0].flag, RowFlag::kBest);
  EXPECT_EQ(table.rows[1].flag, RowFlag::kNone);
}

// A model whose run diverges on the held-out data cannot be the best, however well it fits.
TEST(ParameterTable, NeverMarksAModelBestThatCannotPredictTheHeldOutData) {
  const Table table = ParameterTable(HandmadeDof(
      {HandmadeRow(Family::kLeastSquares, 0.01, kNan), HandmadeRow(Family::kAdaptive, 0.03, 0.9)}));
  EXPECT_EQ(table.rows[0].flag, RowFlag::kNone);
  EXPECT_EQ(table.rows[1].flag, RowFlag::kBest);
}

TEST(ParameterTable, AnUnusableRowIsFlaggedNeverBestAndShowsNoNumber) {
  const Table table = ParameterTable(HandmadeDof(
      {UnusableRow(Family::kLeastSquares), HandmadeRow(Family::kOutputError, 0.2, 0.3)}));
  EXPECT_EQ(table.rows[0].flag, RowFlag::kUnusable);
  EXPECT_EQ(table.rows[1].flag, RowFlag::kBest);
  for (size_t i = 2; i < table.rows[0].cells.size(); ++i) {
    EXPECT_EQ(table.rows[0].cells[i], "-") << table.columns[i].heading;
  }
}

TEST(Comments, AreALineEachForDataRowsAndWhatTheyDoNotCover) {
  DofComparison comparison = HandmadeDof(
      {UnusableRow(Family::kLeastSquares), HandmadeRow(Family::kOutputError, 0.02, 0.03)});
  comparison.findings.resize(2);
  comparison.findings[0].severity = Severity::kWarning;
  comparison.findings[0].sentence = "The power is negative.";
  comparison.findings[1].severity = Severity::kNote;
  comparison.findings[1].sentence = "It is slow.";
  comparison.remarks = {"left out: 3 samples."};
  comparison.rows[0].message = "no motion.";
  comparison.rows[0].fitted.caveats.clear();
  comparison.rows[1].fitted.caveats = {"noisy regressors."};
  EXPECT_THAT(CommentsOn(comparison),
              ElementsAre("note: It is slow.",
                          "note: left out: 3 samples.",
                          "! Least squares, velocity.csv: no motion.",
                          "note: Output error, velocity.csv: noisy regressors."));
}

TEST(ParameterTable, HoldsThePapersColumnsWithUnits) {
  const Table table = ParameterTable(HandmadeDof({HandmadeRow(Family::kOutputError, 0.02, 0.03)}));
  ASSERT_EQ(table.columns.size(), 10u);
  EXPECT_EQ(table.columns[2].heading, "inertia [kg]");
  EXPECT_EQ(table.columns[6].heading, "velocity MAE [m/s]");
  // 40, standard deviation 2.0; the figures as HandmadeRow gives them.
  EXPECT_THAT(table.rows[0].cells,
              ::testing::ElementsAre("surge",
                                     "Output error, velocity.csv",
                                     "40.0 ± 2.0",
                                     "30.0 ± 1.5",
                                     "5.00 ± 0.50",
                                     "-0.50 ± 0.10",
                                     "0.01000",
                                     "0.0200",
                                     "0.00750",
                                     "0.0300"));
}

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

TEST(ComparisonPage, HasALeadASectionAndAFactForEachDof) {
  Comparison comparison;
  comparison.log_name = "tank_07";
  comparison.dofs = {HandmadeDof({HandmadeRow(Family::kOutputError, 0.02, 0.03)}),
                     HandmadeDof({UnusableRow(Family::kAdaptive)})};
  comparison.dofs[1].dof = Dof::kYaw;
  const Page page = ComparisonPage(comparison);
  EXPECT_THAT(page.title, HasSubstr("tank_07"));
  ASSERT_EQ(page.lead.size(), 2u);
  EXPECT_THAT(page.lead[0],
              AllOf(HasSubstr("Surge"),
                    HasSubstr("3.0 %"),
                    HasSubstr("on held-out data"),
                    HasSubstr("40.0 ± 3.9 kg")));
  EXPECT_EQ(page.lead[1], "Yaw: no family found a usable model.");
  ASSERT_EQ(page.sections.size(), 2u);
  EXPECT_EQ(page.sections[0].heading, "Surge");
  EXPECT_EQ(page.sections[1].heading, "Yaw");
  ASSERT_EQ(page.facts.size(), 2u);
  EXPECT_EQ(page.facts[0].value, "5 s training data, 2 s held out");
}

TEST(ComparisonPage, SaysWhereNothingIsHeldOut) {
  Comparison comparison;
  comparison.dofs = {HandmadeDof({HandmadeRow(Family::kOutputError, 0.02, kNan)})};
  comparison.dofs[0].scored.held_out.clear();
  EXPECT_THAT(ComparisonPage(comparison).lead.at(0), HasSubstr("(no data are held out)"));
}

TEST(ComparisonPage, ShowsWarningsOfTheDataAndCaveatsOfTheModels) {
  Comparison comparison;
  auto row = HandmadeRow(Family::kOutputError, 0.02, 0.03);
  row.fitted.caveats = {"a caveat"};
  comparison.dofs = {HandmadeDof({row})};
  comparison.dofs[0].findings = {
      {.severity = Severity::kWarning, .code = "passivity", .sentence = "It gains energy."}};
  comparison.remarks = {"A column is not read."};
  const Page page = ComparisonPage(comparison);
  EXPECT_THAT(page.warnings, ElementsAre("Surge: It gains energy."));
  EXPECT_THAT(page.sections.at(0).notes, ElementsAre("A column is not read."));
  const PageSection& section = page.sections.at(0);
  ASSERT_EQ(section.tables.size(), 3u);
  EXPECT_EQ(section.tables[2].rows.at(0).cells.at(1), "a caveat");
}

TEST(ComparisonPage, ShowsTheFigureThatDecidesFirstAndFoldsTheOthers) {
  Comparison comparison;
  comparison.dofs = {HandmadeDof({HandmadeRow(Family::kOutputError, 0.02, 0.03)})};
  const PageSection section = ComparisonPage(comparison).sections.at(0);
  ASSERT_EQ(section.tables.size(), 2u);
  const Table& shown = section.tables[0];
  EXPECT_EQ(shown.columns.at(1).heading, "velocity NMAE, held out");
  EXPECT_EQ(shown.rows.at(0).cells.at(1), "0.0300");
  EXPECT_THAT(shown.fold, IsEmpty());
  EXPECT_THAT(section.tables[1].fold, HasSubstr("training data"));
  EXPECT_EQ(section.tables[1].columns.size(), 5u);
}

TEST(ComparisonPage, ShowsTheErrorOnTheTrainingDataWhereNoneAreHeldOut) {
  Comparison comparison;
  comparison.dofs = {HandmadeDof({HandmadeRow(Family::kOutputError, 0.02, kNan)})};
  comparison.dofs[0].scored.held_out.clear();
  const PageSection section = ComparisonPage(comparison).sections.at(0);
  EXPECT_EQ(section.tables.at(0).columns.at(1).heading, "velocity NMAE");
  EXPECT_EQ(section.tables.at(0).rows.at(0).cells.at(1), "0.0200");
}

}  // namespace
}  // namespace fathom
