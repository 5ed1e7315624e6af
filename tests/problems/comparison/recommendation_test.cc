// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/comparison/recommendation.h"

#include "fathom/comparison/comparison_page.h"
#include "fathom/identification/identification_text.h"
#include "fathom/log/read_log.h"

#include <algorithm>
#include <cstddef>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;

// Yaw: 0.1330 to 0.1330 on a last minute of noise.
TEST(Recommend, PassesOverALeadThatIsChance) {
  const Log log = ReadLog(FATHOM_DATA_DIR "/flatfish");
  const Comparison comparison = Compare({&log, 1}, {.dofs = {Dof::kYaw}});
  const DofComparison& dof = comparison.dofs.front();
  const Recommendation recommendation = Recommend(dof);
  ASSERT_NE(recommendation.taken, nullptr);
  EXPECT_EQ(recommendation.taken->family, Family::kOutputError);
  ASSERT_FALSE(recommendation.as_good.empty());
  EXPECT_EQ(recommendation.as_good.front()->family, Family::kLeastSquares);
  const Page page = ComparisonPage(comparison);
  EXPECT_THAT(page.lead.front(), HasSubstr("take Output error"));
  EXPECT_THAT(page.lead.front(), HasSubstr("As good within chance: "));
}

// Nine seconds are one block: no interval comes of it.
TEST(Recommend, SaysThatTheDataAreTooFewToTellChance) {
  const Log log = ReadLog(FATHOM_DATA_DIR "/flatfish");
  Comparison comparison = Compare({&log, 1}, {.dofs = {Dof::kYaw}});
  DofComparison& dof = comparison.dofs.front();
  Segment& segment = dof.scored.held_out.front();
  const double to = segment.time.front() + 9.0;
  const auto size =
      static_cast<std::size_t>(std::ranges::upper_bound(segment.time, to) - segment.time.begin());
  for (auto* column : {&segment.time, &segment.velocity}) column->resize(size);
  dof.scored.held_out.resize(1);
  for (Identification& row : dof.rows) {
    row.fitted.held_out.nmae = row.family == Family::kLeastSquares ? 0.10 : 0.16;
  }
  const Recommendation recommendation = Recommend(dof);
  EXPECT_EQ(recommendation.taken->family, Family::kOutputError);
  EXPECT_FALSE(recommendation.is_chance_known);
  EXPECT_THAT(CommentsOn(dof).front(),
              HasSubstr("but the data are too few to tell whether that is chance"));
}

// A model of twice the inertia is worse by far more than chance, whatever its family.
TEST(Recommend, DoesNotCallAWorseModelAsGood) {
  const Log log = ReadLog(FATHOM_DATA_DIR "/flatfish");
  Comparison comparison = Compare({&log, 1}, {.dofs = {Dof::kSurge}});
  DofComparison& dof = comparison.dofs.front();
  for (Identification& row : dof.rows) {
    if (row.family != Family::kOutputError) continue;
    row.fitted.model.inertia *= 2.0;
    ScoreByFreeRuns(dof.scored, &row.fitted);
  }
  const Recommendation recommendation = Recommend(dof);
  EXPECT_EQ(recommendation.taken->family, Family::kLeastSquares);
  EXPECT_EQ(recommendation.as_good.size(), 1u);
}

// A lead of one family, whatever it is, does not count where it is chance: the adaptive law with
// its quadratic damping of 176 +- 29, where the truth is 8.62, is not recommended for a lead of 1
// %.
TEST(Recommend, DoesNotTakeTheAdaptiveLawForALeadThatIsChance) {
  const Log log = ReadLog(FATHOM_DATA_DIR "/flatfish");
  Comparison comparison = Compare({&log, 1}, {.dofs = {Dof::kYaw}});
  DofComparison& dof = comparison.dofs.front();
  for (Identification& row : dof.rows) {
    if (row.family == Family::kAdaptive)
      row.fitted.held_out.nmae = 0.99 * dof.rows[0].fitted.held_out.nmae;
  }
  const Recommendation recommendation = Recommend(dof);
  EXPECT_EQ(recommendation.taken->family, Family::kOutputError);
  ASSERT_NE(recommendation.least, nullptr);
  EXPECT_TRUE(recommendation.is_chance_known);
  EXPECT_EQ(CommentsOn(dof).front(),
            "* the row to take: its parameters are known best. " +
                ModelName(*recommendation.least) +
                " has a lower held-out NMAE (the error of the velocity, simulated from the command "
                "alone), but by no more than chance");
}

// A joint row whose refinement failed holds the model of another family, and ranks as that.
TEST(Recommend, RanksAStandInAsWhatItIs) {
  const Log log = ReadLog(FATHOM_DATA_DIR "/flatfish");
  Comparison comparison = Compare({&log, 1}, {.dofs = {Dof::kYaw}});
  DofComparison& dof = comparison.dofs.front();
  Identification joint =
      *std::ranges::find(dof.rows, Family::kLeastSquares, &Identification::family);
  joint.family = Family::kJoint;
  dof.rows.push_back(joint);
  EXPECT_EQ(Recommend(dof).taken->family, Family::kJoint);
  dof.rows.back().stand_in = Family::kLeastSquares;
  EXPECT_EQ(Recommend(dof).taken->family, Family::kOutputError);
}

TEST(Recommend, NeverTakesAnUnusableModel) {
  const Log log = ReadLog(FATHOM_DATA_DIR "/flatfish");
  Comparison comparison = Compare({&log, 1}, {.dofs = {Dof::kSurge}});
  DofComparison& dof = comparison.dofs.front();
  for (Identification& row : dof.rows) row.is_usable = row.family == Family::kAdaptive;
  EXPECT_EQ(Recommend(dof).taken->family, Family::kAdaptive);
  dof.rows.clear();
  EXPECT_EQ(Recommend(dof).taken, nullptr);
}

}  // namespace
}  // namespace fathom
