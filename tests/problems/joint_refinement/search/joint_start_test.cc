// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/search/joint_start.h"

#include "fathom/joint_refinement/joint_refinement.h"
#include "fathom/joint_refinement/search/fit_from.h"

#include <cmath>

#include "camera_experiment.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

// Within four reported standard deviations, and those of the inertia are small.
void ExpectModel(const JointSummary& summary, const SyntheticCameraRun& run) {
  ASSERT_TRUE(summary.IsUsable()) << summary.message;
  const ParameterVector found = ToVector(summary.model), truth = ToVector(run.truth);
  for (int i = 0; i < kNumParameters; ++i) {
    EXPECT_NEAR(found[i], truth[i], 4.0 * std::sqrt(summary.covariance(i, i)))
        << kParameterInfo[i].name;
  }
  EXPECT_LT(std::sqrt(summary.covariance(kInertia, kInertia)), 0.012 * run.truth.inertia);
}

// In two of fifteen such runs, of which this is one, the search from the frames' own poses does not
// end.
TEST(JointStart, IsFoundBeforeADistantMarkerSeenFaceOn) {
  const SyntheticCameraRun run = Synthesize(BeforeADistantMarker(60.0, 11));
  ExpectModel(FitJoint(Tracked(run)), run);
}

TEST(JointStart, LeadsToTheSameEndHeldStillAsTracked) {
  const SyntheticCameraRun run =
      Synthesize({.dof = Dof::kHeave, .input = InputKind::kMultisine, .duration = 60.0, .seed = 2});
  const JointSummary tracked = FitFrom(run.input, {}, StartPoses::kTracked);
  const JointSummary held_still = FitFrom(run.input, {}, StartPoses::kHeldStill);
  ExpectModel(tracked, run);
  ExpectModel(held_still, run);
  EXPECT_NEAR(held_still.model.inertia,
              tracked.model.inertia,
              0.1 * std::sqrt(tracked.covariance(kInertia, kInertia)));
}

}  // namespace
}  // namespace fathom
