// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/comparison/comparison_page.h"

#include "fathom/base/not_known.h"

#include "handmade_comparison.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

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

TEST(ParameterTable, MarksNoModelThatIsWorseThanStandingStill) {
  const Table table = ParameterTable(HandmadeDof({HandmadeRow(Family::kOutputError, 0.02, 1.01)}));
  EXPECT_EQ(table.rows.at(0).flag, RowFlag::kNone);
}

TEST(ParameterTable, GoesByTheTrainingDataWhereNoneAreHeldOut) {
  DofComparison comparison = HandmadeDof({HandmadeRow(Family::kLeastSquares, 0.01, kNotKnown),
                                          HandmadeRow(Family::kAdaptive, 0.03, kNotKnown)});
  comparison.scored.held_out.clear();
  const Table table = ParameterTable(comparison);
  EXPECT_EQ(table.rows[0].flag, RowFlag::kBest);
  EXPECT_EQ(table.rows[1].flag, RowFlag::kNone);
}

// A model whose run diverges on the held-out data cannot be the best, however well it fits.
TEST(ParameterTable, NeverMarksAModelBestThatCannotPredictTheHeldOutData) {
  const Table table =
      ParameterTable(HandmadeDof({HandmadeRow(Family::kLeastSquares, 0.01, kNotKnown),
                                  HandmadeRow(Family::kAdaptive, 0.03, 0.9)}));
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
              ElementsAre("* the row to take: no other row has a lower held-out NMAE (the error of "
                          "the velocity, simulated from the command alone)",
                          "note: It is slow.",
                          "note: left out: 3 samples.",
                          "! Least squares, velocity.csv: no motion.",
                          "note: Output error, velocity.csv: noisy regressors."));
}

TEST(ParameterTable, HoldsThePapersColumnsWithUnits) {
  const Table table = ParameterTable(HandmadeDof({HandmadeRow(Family::kOutputError, 0.02, 0.03)}));
  ASSERT_EQ(table.columns.size(), 10u);
  EXPECT_EQ(table.columns[2].heading, "inertia [kg]");
  EXPECT_EQ(table.columns[6].heading, "training MAE [m/s]");
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
                    HasSubstr("Inertia 40 kg (36 to 44 kg)")));
  EXPECT_EQ(page.lead[1], "Yaw: no family found a usable model.");
  ASSERT_EQ(page.sections.size(), 2u);
  EXPECT_EQ(page.sections[0].heading, "Surge");
  EXPECT_EQ(page.sections[1].heading, "Yaw");
  ASSERT_EQ(page.facts.size(), 2u);
  EXPECT_EQ(page.facts[0].value, "5 s training data, 2 s held out");
}

// A model that stands still has an NMAE of 1.
TEST(ComparisonPage, SaysHowFarTheModelToTakeCanBeTrusted) {
  const auto lead = [](double nmae) {
    Comparison comparison;
    comparison.dofs = {HandmadeDof({HandmadeRow(Family::kOutputError, 0.02, nmae)})};
    return ComparisonPage(comparison).lead.at(0);
  };
  EXPECT_THAT(lead(0.29), HasSubstr("take Output error, velocity.csv. Simulated"));
  EXPECT_THAT(lead(0.31), HasSubstr("take Output error, velocity.csv, though it fits poorly."));
  EXPECT_THAT(lead(3.38),
              HasSubstr("take none. Simulated from the command alone, the best one, Output error, "
                        "velocity.csv, misses 338 % of the speed on held-out data; a model that "
                        "stands still misses 100 %."));
}

TEST(ComparisonPage, SaysWhereNothingIsHeldOut) {
  Comparison comparison;
  comparison.dofs = {HandmadeDof({HandmadeRow(Family::kOutputError, 0.02, kNotKnown)})};
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

TEST(ComparisonPage, SaysFirstWhatIsRed) {
  Comparison comparison;
  comparison.dofs = {HandmadeDof({HandmadeRow(Family::kOutputError, 0.02, 0.03)})};
  comparison.dofs[0].findings = {{Severity::kWarning, "passivity", "It gains energy."}};
  EXPECT_THAT(
      ComparisonPage(comparison).lead.at(0),
      StartsWith("Surge: One red finding has to be explained before a model of this log can "
                 "be believed. Then take Output error, velocity.csv. Simulated"));
}

TEST(ComparisonPage, ShowsTheFigureThatDecidesFirstAndFoldsTheOthers) {
  Comparison comparison;
  comparison.dofs = {HandmadeDof({HandmadeRow(Family::kOutputError, 0.02, 0.03)})};
  const PageSection section = ComparisonPage(comparison).sections.at(0);
  ASSERT_EQ(section.tables.size(), 2u);
  const Table& shown = section.tables[0];
  EXPECT_EQ(shown.columns.at(1).heading, "held-out NMAE");
  EXPECT_EQ(shown.rows.at(0).cells.at(1), "0.0300");
  EXPECT_THAT(shown.fold, IsEmpty());
  EXPECT_THAT(section.tables[1].fold, HasSubstr("training data"));
  EXPECT_EQ(section.tables[1].columns.size(), 5u);
}

TEST(ComparisonPage, ShowsTheErrorOnTheTrainingDataWhereNoneAreHeldOut) {
  Comparison comparison;
  comparison.dofs = {HandmadeDof({HandmadeRow(Family::kOutputError, 0.02, kNotKnown)})};
  comparison.dofs[0].scored.held_out.clear();
  const PageSection section = ComparisonPage(comparison).sections.at(0);
  EXPECT_EQ(section.tables.at(0).columns.at(1).heading, "training NMAE");
  EXPECT_EQ(section.tables.at(0).rows.at(0).cells.at(1), "0.0200");
}

}  // namespace
}  // namespace fathom
