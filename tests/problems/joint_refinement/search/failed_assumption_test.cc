// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/search/failed_assumption.h"

#include "fathom/joint_refinement/joint_refinement.h"
#include "fathom/joint_refinement/search/fit_from.h"

#include <algorithm>
#include <cmath>
#include <regex>
#include <string>

#include "camera_experiment.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;

// The number before " s" in what is said of the offset; NaN if nothing is.
double OffsetIn(const std::string& text) {
  std::smatch match;
  const bool is_told = std::regex_search(text, match, std::regex("offset of (about )?([-0-9.]+)"));
  return is_told ? std::stod(match[2]) : std::nan("");
}

// A vehicle in closed loop: force and motion a third of a second apart hardly fit any model.
TEST(FailedAssumption, IsTheClockWhereThatIsOff) {
  const SyntheticCameraRun run = Synthesize({.dof = Dof::kHeave,
                                             .input = InputKind::kMultisine,
                                             .duration = 60.0,
                                             .clock_offset = 0.3,
                                             .seed = 3});
  const std::string text = FailedAssumption(run.input, {}, true);
  EXPECT_THAT(text, HasSubstr("The corners contradict an exact camera clock"));
  EXPECT_NEAR(OffsetIn(text), 0.3, 0.03);
}

// Where a model error takes up the difference, the search ends, and the inertia is wrong.
TEST(FailedAssumption, IsACaveatWhereTheSearchEndsNonetheless) {
  const SyntheticCameraRun run = Synthesize({.dof = Dof::kYaw,
                                             .input = InputKind::kMultisine,
                                             .duration = 60.0,
                                             .clock_offset = 0.3,
                                             .seed = 3});
  const JointSummary summary = FitJoint(run.input);
  ASSERT_TRUE(summary.IsUsable()) << summary.message;
  const auto caveat = std::ranges::find_if(summary.caveats, [](const std::string& text) {
    return text.find("exact camera clock") != std::string::npos;
  });
  ASSERT_NE(caveat, summary.caveats.end());
  EXPECT_NEAR(OffsetIn(*caveat), 0.3, 0.1);
}

// Size and mount move once the processes have settled. A search that ends before is the same with a
// free size, which is not searched for then.
TEST(FailedAssumption, IsNotTheSizeWhereTheSearchDoesNotComeToIt) {
  const SyntheticCameraRun run =
      Synthesize({.dof = Dof::kSurge, .input = InputKind::kMultisine, .duration = 20.0});
  JointOptions options;
  options.max_iterations = 1;
  const JointSummary held = FitFrom(run.input, options, StartPoses::kTracked);
  ASSERT_FALSE(held.converged);
  EXPECT_FALSE(held.reached_setup);
  options.size_scale_std = 0.1;
  const JointSummary free = FitFrom(run.input, options, StartPoses::kTracked);
  EXPECT_FALSE(free.converged);
  EXPECT_EQ(free.final_cost, held.final_cost);
}

TEST(FailedAssumption, IsNoneWhereTheClockIsRight) {
  for (const unsigned seed : {1u, 2u}) {
    for (const Dof dof : {Dof::kSurge, Dof::kYaw}) {
      const SyntheticCameraRun run =
          Synthesize({.dof = dof, .input = InputKind::kMultisine, .duration = 40.0, .seed = seed});
      const JointSummary summary = FitJoint(run.input);
      ASSERT_TRUE(summary.IsUsable()) << summary.message;
      for (const std::string& caveat : summary.caveats) {
        EXPECT_EQ(caveat.find("exact camera clock"), std::string::npos) << caveat;
      }
    }
  }
}

}  // namespace
}  // namespace fathom
