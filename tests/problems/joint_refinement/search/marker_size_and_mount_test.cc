// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/search/marker_size_and_mount.h"

#include "fathom/joint_refinement/joint_refinement.h"

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "camera_experiment.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

constexpr double kSizeStd = 0.03, kMountStd = 0.1;

// A vehicle whose marker, or whose camera's place too, is off by a draw from what is known of it.
CameraExperiment Drawn(unsigned seed, CameraExperiment experiment, double mount_std) {
  std::mt19937 generator(seed + 1000);
  std::normal_distribution<double> normal;
  experiment.seed = seed;
  experiment.input = InputKind::kMultisine;
  experiment.size_scale = 1.0 + kSizeStd * normal(generator);
  for (double& error : experiment.mount_error) error = mount_std * normal(generator);
  return experiment;
}

double InertiaStd(const JointSummary& summary) {
  return std::sqrt(summary.covariance(kInertia, kInertia));
}

// In a world twice as large, what is a length in the processes is twice as large, and a response
// per unit of the motion goes with the coordinate over the motion.
TEST(SetupFit, ScalesTheProcessesWithTheWorld) {
  ProcessSet processes;
  for (int j = 0; j < kNumHeld; ++j) {
    processes.wander[j] = {0.1 * (j + 1), 0.5, 1.0};
    processes.response_std[j] = 0.2;
  }
  processes.model_error = 3.0;
  const ProcessSet surge = Scaled(processes, Index(Dof::kSurge), 2.0);
  const ProcessSet yaw = Scaled(processes, Index(Dof::kYaw), 2.0);
  for (int j = 0; j < 2; ++j) {  // sway, heave
    EXPECT_DOUBLE_EQ(surge.wander[j].std, 0.2 * (j + 1));
    EXPECT_DOUBLE_EQ(surge.response_std[j], 0.2);
  }
  for (int j = 2; j < 5; ++j) {  // roll, pitch, yaw
    EXPECT_DOUBLE_EQ(surge.wander[j].std, 0.1 * (j + 1));
    EXPECT_DOUBLE_EQ(surge.response_std[j], 0.1);
  }
  for (int j = 0; j < 3; ++j) EXPECT_DOUBLE_EQ(yaw.response_std[j], 0.4);  // surge, sway, heave
  for (int j = 3; j < 5; ++j) EXPECT_DOUBLE_EQ(yaw.response_std[j], 0.2);  // roll, pitch
  EXPECT_DOUBLE_EQ(surge.model_error, 12.0);
  EXPECT_DOUBLE_EQ(yaw.model_error, 3.0);
}

// A single marker face on tells nothing of its own size, however the held coordinates wander: what
// was known of it is what comes out, and the inertia is as wide.
TEST(SetupFit, LearnsNothingOfTheSizeFromOneMarker) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const CameraExperiment experiment = Drawn(seed, {.duration = 60.0}, 0.0);
    const SyntheticCameraRun run = Synthesize(experiment);
    const JointSummary summary = FitJoint(run.input, {.size_scale_std = kSizeStd});
    ASSERT_TRUE(summary.IsUsable()) << summary.message;
    EXPECT_NEAR(summary.size_scale, 1.0, 0.2 * kSizeStd) << seed;
    EXPECT_GT(summary.size_scale_std, 0.95 * kSizeStd) << seed;
    EXPECT_LT(summary.size_scale_std, 1.01 * kSizeStd) << seed;
    EXPECT_NEAR(summary.model.inertia, run.truth.inertia, 4.0 * InertiaStd(summary)) << seed;
    EXPECT_NEAR(InertiaStd(summary), kSizeStd * run.truth.inertia, 0.15 * kSizeStd * 851.0) << seed;
    // Displacement and inertia go with one another: the same force moves the same picture.
    const double by_size = run.truth.inertia * experiment.size_scale / summary.size_scale;
    EXPECT_NEAR(summary.model.inertia, by_size, 0.005 * by_size) << seed;
  }
}

// Without any knowledge of it there is only the camera's arm: the body's small turns swing the
// camera by so many metres, and move the picture by more the nearer the marker is.
TEST(SetupFit, SaysHowLittleOneMarkerTellsOfItsSize) {
  const SyntheticCameraRun run =
      Synthesize({.input = InputKind::kMultisine, .duration = 30.0, .seed = 2});
  const JointSummary summary =
      FitJoint(run.input, {.size_scale_std = std::numeric_limits<double>::infinity()});
  ASSERT_TRUE(summary.IsUsable()) << summary.message;
  EXPECT_GT(summary.size_scale_std, 3.0 * kSizeStd);
  EXPECT_NEAR(summary.size_scale, 1.0, 4.0 * summary.size_scale_std);
}

constexpr double kUnknown = std::numeric_limits<double>::infinity();

SyntheticCameraRun TwentySeconds(WanderKind wander) {
  return Synthesize(
      {.input = InputKind::kMultisine, .duration = 20.0, .wander = wander, .seed = 2});
}

void ExpectNoTrace(const SyntheticCameraRun& run, const JointOptions& options) {
  const JointSummary summary = FitJoint(run.input, options);
  EXPECT_FALSE(summary.IsUsable());
  EXPECT_EQ(summary.message, "the corners do not determine some unknown.");
}

// The direction of the camera and the mean angles of a vehicle that never turns are one and the
// same to the corners. With nothing known beforehand there is no answer, and it says why; with
// something, there is.
TEST(SetupFit, SaysThatTheDirectionOfTheCameraLeavesNoTraceIfTheVehicleNeverTurns) {
  const SyntheticCameraRun still = TwentySeconds(WanderKind::kNone);
  ExpectNoTrace(still, {.mount_angle_std = kUnknown});
  const JointSummary known = FitJoint(still.input, {.mount_angle_std = 0.02});
  ASSERT_TRUE(known.IsUsable()) << known.message;
  EXPECT_NEAR(known.mount_std[3], 0.02, 0.002);
}

// Nor do size, place and direction together if it wanders a little.
TEST(SetupFit, SaysThatSizeAndMountTogetherLeaveNoTraceIfTheVehicleWandersALittle) {
  ExpectNoTrace(
      TwentySeconds(WanderKind::kFiltered),
      {.size_scale_std = kUnknown, .mount_position_std = kUnknown, .mount_angle_std = kUnknown});
}

// Errors over reported standard deviations, over draws of what is to be found: of mean 0 and root
// mean square 1.
void ExpectCalibrated(CameraExperiment experiment, unsigned first, unsigned last) {
  std::vector<double> z;
  for (unsigned seed = first; seed <= last; ++seed) {
    const CameraExperiment drawn = Drawn(seed, experiment, kMountStd);
    const SyntheticCameraRun run = Synthesize(drawn);
    const JointSummary summary =
        FitJoint(run.input, {.size_scale_std = kSizeStd, .mount_position_std = kMountStd});
    ASSERT_TRUE(summary.IsUsable()) << summary.message;
    z.push_back((summary.size_scale - drawn.size_scale) / summary.size_scale_std);
    for (int i = 0; i < 3; ++i) {
      EXPECT_LT(summary.mount_std[i], 1.01 * kMountStd);
      z.push_back((summary.mount[i] - drawn.mount_error[i]) / summary.mount_std[i]);
    }
    z.push_back((summary.model.inertia - run.truth.inertia) / InertiaStd(summary));
  }
  double sum = 0.0, squares = 0.0;
  for (const double value : z) {
    EXPECT_LT(std::abs(value), 4.0);
    sum += value;
    squares += value * value;
  }
  // Four standard deviations of a mean and of a root mean square of so many normal numbers.
  const auto n = static_cast<double>(z.size());
  EXPECT_LT(std::abs(sum), 4.0 * std::sqrt(n));
  EXPECT_GT(std::sqrt(squares / n), 1.0 - 4.0 / std::sqrt(2.0 * n));
  EXPECT_LT(std::sqrt(squares / n), 1.0 + 4.0 / std::sqrt(2.0 * n));
}

TEST(SetupFit, FindsSizeAndMountFromOneMarkerAsWellAsItSays) {
  ExpectCalibrated({.duration = 40.0}, 1, 3);
}

TEST(SetupFit, FindsSizeAndMountFromFourMarkersAsWellAsItSays) {
  ExpectCalibrated({.num_markers = 4, .duration = 20.0}, 1, 2);
}

}  // namespace
}  // namespace fathom
