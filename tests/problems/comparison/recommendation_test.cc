// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/comparison/recommendation.h"

#include "fathom/comparison/comparison_page.h"
#include "fathom/log/read_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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
