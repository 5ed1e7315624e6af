// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// What a refinement says of a log beyond its intervals, held against refinements that know less.

#include "fathom/joint_refinement/joint_refinement.h"

#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include "camera_experiment.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

std::string CaveatWith(const JointSummary& summary, std::string_view words) {
  for (const std::string& caveat : summary.caveats) {
    if (caveat.find(words) != std::string::npos) return caveat;
  }
  return "";
}

double NumberAfter(const std::string& text, const std::string& words) {
  const size_t at = text.find(words);
  return at == std::string::npos ? std::nan("") : std::stod(text.substr(at + words.size()));
}

double HalfWidth(const JointSummary& summary, int parameter) {
  return 1.96 * std::sqrt(summary.covariance(parameter, parameter));
}

TEST(JointCaveats, SayWhatADelayOfTheCommandWouldChangeUnderASine) {
  const SyntheticCameraRun run = Synthesize({.duration = 120.0, .wander = WanderKind::kNone});
  const JointSummary summary = FitJoint(run.input);
  ASSERT_TRUE(summary.IsUsable()) << summary.message;
  const std::string caveat =
      CaveatWith(summary, "cannot separate inertia, damping and a command delay");
  ASSERT_NE(caveat, "");

  // The same images with the clock free.
  const JointSummary free =
      FitJoint(run.input, {.clock_offset_std = std::numeric_limits<double>::infinity()});
  ASSERT_TRUE(free.IsUsable()) << free.message;
  EXPECT_NEAR(NumberAfter(caveat, "is known to ± "),
              HalfWidth(free, kInertia),
              0.1 * HalfWidth(free, kInertia));
  EXPECT_EQ(CaveatWith(free, "command delay"), "");

  // The same images under a command that comes earlier. (Later, a damping would end on its bound.)
  constexpr double kDelay = -0.02;  // [s]
  JointInput early = run.input;
  for (double& t : early.segments[0].command.time) t += kDelay;
  const JointSummary delayed = FitJoint(early);
  ASSERT_TRUE(delayed.IsUsable()) << delayed.message;
  const double inertia = (delayed.model.inertia - summary.model.inertia) / kDelay;
  const double damping = (delayed.model.linear_damping - summary.model.linear_damping) / kDelay;
  EXPECT_NEAR(NumberAfter(caveat, "change the inertia by "), inertia, 0.15 * std::abs(inertia));
  EXPECT_NEAR(NumberAfter(caveat, "the linear damping by "), damping, 0.15 * std::abs(damping));
}

TEST(JointCaveats, AreSilentOnADelayThatStepsTell) {
  const SyntheticCameraRun run =
      Synthesize({.input = InputKind::kSteps, .duration = 120.0, .wander = WanderKind::kNone});
  const JointSummary summary = FitJoint(run.input);
  ASSERT_TRUE(summary.IsUsable()) << summary.message;
  EXPECT_EQ(CaveatWith(summary, "command delay"), "");
}

TEST(JointCaveats, NameTheDampingThatALogDoesNotDetermine) {
  // Corners that are far worse than a camera's, so that the sine leaves its two dampings in doubt.
  const SyntheticCameraRun run =
      Synthesize({.duration = 60.0, .corner_noise = 10.0, .wander = WanderKind::kNone});
  const JointSummary summary = FitJoint(run.input);
  ASSERT_TRUE(summary.IsUsable()) << summary.message;
  const ParameterVector found = ToVector(summary.model);
  int num_in_doubt = 0;
  for (const int i : {kQuadraticDamping, kLinearDamping}) {
    const bool in_doubt = !summary.on_bound[i] && HalfWidth(summary, i) > found[i];
    if (in_doubt) ++num_in_doubt;
    const std::string name = i == kQuadraticDamping ? "quadratic damping" : "linear damping";
    EXPECT_EQ(CaveatWith(summary, "This log does not determine " + name) != "", in_doubt) << name;
  }
  EXPECT_GT(num_in_doubt, 0) << found.transpose();
}

}  // namespace
}  // namespace fathom
