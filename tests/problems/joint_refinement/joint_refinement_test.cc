// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/joint_refinement.h"

#include "fathom/base/input_error.h"
#include "fathom/least_squares/least_squares.h"
#include "fathom/output_error/output_error.h"
#include "fathom/signal/signals.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "camera_experiment.h"
#include "cramer_rao.h"
#include "expect_found.h"
#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(JointRefinement, FindsSurgeFromOneMarker) {
  const SyntheticCameraRun run = Synthesize({.duration = 60.0});
  const JointSummary summary = FitJoint(run.input);
  ExpectFound(summary, run, 0.005);
  // 600 frames of eight rows, most of them left after the fit: 3 % is four standard deviations.
  EXPECT_NEAR(summary.processes.corner_sigma, 0.3, 0.3 * 0.05);
}

TEST(JointRefinement, RecoversTheModelFromPerfectCorners) {
  const SyntheticCameraRun run = Synthesize(
      {.dof = Dof::kYaw, .duration = 60.0, .corner_noise = 1e-4, .wander = WanderKind::kNone});
  const JointSummary summary = FitJoint(run.input);
  ASSERT_TRUE(summary.IsUsable()) << summary.message;
  EXPECT_NEAR(summary.model.inertia, run.truth.inertia, 1e-4 * run.truth.inertia);
  EXPECT_NEAR(summary.model.quadratic_damping,
              run.truth.quadratic_damping,
              1e-2 * run.truth.quadratic_damping);
}

// The refined path is held against that of PnP on the same motion without flips and outliers: with
// them, PnP's own errors would make it easy.
TEST(JointRefinement, IsNotMisledByFlipsAndOutliers) {
  for (const Dof dof : {Dof::kSurge, Dof::kHeave, Dof::kYaw}) {
    SCOPED_TRACE(Name(dof));
    CameraExperiment experiment = {.dof = dof, .input = InputKind::kMultisine, .duration = 60.0};
    const SyntheticCameraRun clean = Synthesize(experiment);
    experiment.outliers = 0.02;
    experiment.flips = 0.05;
    const SyntheticCameraRun run = Synthesize(experiment);
    const JointSummary summary = FitJoint(run.input);
    ExpectFound(summary, run, dof == Dof::kHeave ? 0.02 : 0.01);
    EXPECT_LT(PathError(summary.segments[0].world_from_body, run),
              0.6 * PathError(clean.input.segments[0].world_from_body, clean));
    EXPECT_GE(summary.segments[0].num_outliers, 5);  // 12 expected
    EXPECT_LE(summary.segments[0].num_outliers, 30);
  }
}

// Frame by frame the noise of the tilt shortens the distance to a marker seen face on, more so from
// afar: least squares shows 0.4 to 1.2 % too little of the motion in twelve seeds. All frames
// together do not, to what the corners can tell of a scale, which is how well they tell the
// inertia; and need no model for it: the command here is nonsense.
TEST(JointRefinement, FollowsAMotionTowardsTheMarkerWithoutAModel) {
  const auto share_of = [](const std::vector<double>& shown, const std::vector<double>& truth) {
    double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
    const auto n = static_cast<double>(truth.size());
    for (size_t k = 0; k < truth.size(); ++k) {
      sx += truth[k];
      sy += shown[k];
      sxx += truth[k] * truth[k];
      sxy += truth[k] * shown[k];
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
  };
  const auto ahead = [](const std::vector<Pose>& path) {
    std::vector<double> x;
    for (const Pose& pose : path) x.push_back(pose.translation.x());
    return x;
  };
  const CameraExperiment experiment = {
      .dof = Dof::kSurge, .input = InputKind::kMultisine, .duration = 120.0};
  SyntheticCameraRun run = Synthesize(experiment);
  const double std = CramerRaoStd(experiment, run)[kInertia] / run.truth.inertia;
  EXPECT_LT(std, 0.001);
  EXPECT_LT(share_of(ahead(run.input.segments[0].world_from_body), run.true_displacement), 0.997);
  run.input.segments[0].command = {{0.0, 1.0}, {1e6, -1e6}};
  const JointSummary summary = FitJoint(run.input, {.moves_freely = true});
  ASSERT_TRUE(summary.IsUsable()) << summary.message;
  EXPECT_NEAR(
      share_of(ahead(summary.segments[0].world_from_body), run.true_displacement), 1.0, 4.0 * std);
  EXPECT_LT(PathError(summary.segments[0].world_from_body, run),
            0.3 * PathError(run.input.segments[0].world_from_body, run));
  EXPECT_TRUE(std::isnan(summary.model.inertia));
  EXPECT_THROW(FitJoint(run.input, {.moves_freely = true, .clock_offset_std = 1.0}), InputError);
}

// Who ignores that pitch follows gets the inertia wrong by a quarter.
TEST(JointRefinement, IsNotMisledByAPitchThatFollowsTheHeaveAcceleration) {
  for (const unsigned seed : {1u, 2u}) {
    SCOPED_TRACE(seed);
    const SyntheticCameraRun run = Synthesize({.dof = Dof::kHeave,
                                               .input = InputKind::kMultisine,
                                               .duration = 300.0,
                                               .pitch_per_acceleration = 0.5,
                                               .seed = seed});
    const JointSummary summary = FitJoint(run.input);
    ExpectFound(summary, run, 0.01);
    EXPECT_NEAR(summary.model.inertia, run.truth.inertia, 0.01 * run.truth.inertia);
    // Held slot 3 is pitch: it is heave's own coordinate that is missing among the held ones.
    EXPECT_GT(summary.processes.response_std[3], 0.0);
  }
}

// A vehicle that holds its DOFs wholly shows responses of a millionth of a radian. Chance alone
// looks like one in these runs, by one to two in log-likelihood; it would make the interval of the
// inertia up to eight times too wide. One of 2e-4 rad s^2/m, a two-thousandth of what the test
// above has, is no chance.
TEST(JointRefinement, TellsASmallResponseFromChance) {
  struct Motion {
    Dof dof;
    unsigned seed;
  };
  for (const auto& [dof, seed] :
       {Motion{Dof::kYaw, 5}, Motion{Dof::kYaw, 15}, Motion{Dof::kHeave, 32}}) {
    const CameraExperiment experiment = {.dof = dof,
                                         .input = InputKind::kSine,
                                         .duration = 300.0,
                                         .wander = WanderKind::kNone,
                                         .seed = seed};
    const SyntheticCameraRun run = Synthesize(experiment);
    const JointSummary summary = FitJoint(run.input);
    ASSERT_TRUE(summary.IsUsable()) << summary.message;
    for (const double std : summary.processes.response_std) EXPECT_EQ(std, 0.0) << Name(dof);
    EXPECT_LT(std::sqrt(summary.covariance(kInertia, kInertia)),
              1.1 * CramerRaoStd(experiment, run)[kInertia]);
  }
  const JointSummary summary = FitJoint(Synthesize({.dof = Dof::kHeave,
                                                    .input = InputKind::kMultisine,
                                                    .duration = 300.0,
                                                    .wander = WanderKind::kNone,
                                                    .pitch_per_acceleration = 2e-4})
                                            .input);
  ASSERT_TRUE(summary.IsUsable()) << summary.message;
  EXPECT_GT(summary.processes.response_std[3], 0.0);
}

// Errors hang together over the wander's few seconds: of two minutes some forty are independent,
// and a root mean square of 1 is known to a tenth.
TEST(JointRefinement, ReportsHowFarThePosesAreOff) {
  const SyntheticCameraRun run = Synthesize({.dof = Dof::kYaw, .duration = 120.0});
  const JointSummary summary = FitJoint(run.input);
  ASSERT_TRUE(summary.IsUsable()) << summary.message;
  const RefinedSegment& refined = summary.segments[0];
  ASSERT_EQ(refined.pose_covariance.size(), run.true_world_from_body.size());
  Eigen::Matrix<double, 6, 1> squares = Eigen::Matrix<double, 6, 1>::Zero();
  for (size_t k = 0; k < refined.pose_covariance.size(); ++k) {
    const Pose& truth = run.true_world_from_body[k];
    const Pose& found = refined.world_from_body[k];
    const Eigen::AngleAxisd turn(found.rotation.conjugate() * truth.rotation);
    Eigen::Matrix<double, 6, 1> error;
    error << truth.translation - found.translation, turn.angle() * turn.axis();
    squares += error.cwiseAbs2().cwiseQuotient(refined.pose_covariance[k].diagonal());
  }
  const double count = static_cast<double>(refined.pose_covariance.size());
  for (int i = 0; i < 5; ++i) {
    EXPECT_GT(std::sqrt(squares[i] / count), 0.6) << i;
    EXPECT_LT(std::sqrt(squares[i] / count), 1.4) << i;
  }
  // Yaw follows the model, whose start and parameters are a handful of numbers.
  EXPECT_LT(std::sqrt(squares[5] / count), 3.0);
}

// A force that the command does not show makes the motion differ from any simulation. Without a
// model error in the problem the intervals would be those of the corners alone, 0.02 %.
TEST(JointRefinement, AdmitsAForceThatTheModelMisses) {
  const SyntheticCameraRun run =
      Synthesize({.input = InputKind::kMultisine, .duration = 120.0, .disturbance = 1.0});
  const JointSummary summary = FitJoint(run.input);
  ExpectFound(summary, run, 0.05);
  EXPECT_GT(summary.processes.model_error, 0.0);
  const SyntheticCameraRun without =
      Synthesize({.input = InputKind::kMultisine, .duration = 120.0});
  const JointSummary sure = FitJoint(without.input);
  ASSERT_TRUE(sure.IsUsable()) << sure.message;
  EXPECT_EQ(sure.processes.model_error, 0.0);
  EXPECT_GT(summary.covariance(kInertia, kInertia), 4.0 * sure.covariance(kInertia, kInertia));
}

// The intervals are as narrow as any unbiased estimate's could be, and no narrower: what the search
// has to find out about the wander costs a tenth or two.
TEST(JointRefinement, ReportsIntervalsAtTheCramerRaoBound) {
  for (const Dof dof : {Dof::kSurge, Dof::kHeave, Dof::kYaw}) {
    const CameraExperiment experiment = {
        .dof = dof, .input = InputKind::kMultisine, .duration = 120.0, .seed = 4};
    const SyntheticCameraRun run = Synthesize(experiment);
    const JointSummary summary = FitJoint(run.input);
    ASSERT_TRUE(summary.IsUsable()) << summary.message;
    const ParameterVector bound = CramerRaoStd(experiment, run);
    const ParameterVector found = ToVector(summary.model), truth = ToVector(run.truth);
    for (int i = 0; i < kNumParameters; ++i) {
      const double std = std::sqrt(summary.covariance(i, i));
      EXPECT_GT(std, 0.75 * bound[i]) << Name(dof) << " " << kParameterInfo[i].name;
      EXPECT_LT(std, 1.3 * bound[i]) << Name(dof) << " " << kParameterInfo[i].name;
      EXPECT_NEAR(found[i], truth[i], 4.0 * bound[i]) << Name(dof) << " " << kParameterInfo[i].name;
    }
  }
}

// Of five motions of one vehicle, each a fresh draw: by a tenth of least squares' error, by less
// than output error's, and with a path better than PnP's in every run.
TEST(JointRefinement, IsBetterThanWhatWorksOnPoses) {
  std::vector<double> joint, output_error, least_squares;
  for (unsigned seed = 11; seed < 16; ++seed) {
    const SyntheticCameraRun run =
        Synthesize({.input = InputKind::kMultisine, .duration = 100.0, .seed = seed});
    const JointSummary summary = FitJoint(run.input);
    ASSERT_TRUE(summary.IsUsable()) << summary.message;
    const Signals signals = SignalsOf(PoseLog(run), run.input.dof, {.source = Source::kCamera});
    const auto error = [&](const auto& fit) {
      EXPECT_TRUE(fit.IsUsable()) << fit.message;
      return std::abs(fit.model.inertia - run.truth.inertia);
    };
    joint.push_back(error(summary));
    least_squares.push_back(error(FitLeastSquares(signals.train)));
    output_error.push_back(error(
        FitOutputError(signals.train, {.initial_guess = {}, .output = FittedOutput::kPosition})));
    EXPECT_LT(PathError(summary.segments[0].world_from_body, run),
              0.6 * PathError(run.input.segments[0].world_from_body, run));
  }
  const auto median = [](std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
  };
  EXPECT_LT(median(joint), 0.1 * median(least_squares));
  EXPECT_LT(1.3 * median(joint), median(output_error));
}

TEST(JointRefinement, FitsSeveralRunsTogether) {
  SyntheticCameraRun run = Synthesize({.dof = Dof::kYaw, .duration = 40.0});
  const JointSummary alone = FitJoint(run.input);
  const SyntheticCameraRun second =
      Synthesize({.dof = Dof::kYaw, .input = InputKind::kMultisine, .duration = 40.0, .seed = 2});
  run.input.segments.push_back(second.input.segments[0]);
  const JointSummary together = FitJoint(run.input);
  ExpectFound(together, run, 0.02);
  ASSERT_EQ(together.segments.size(), 2);
  EXPECT_LT(together.covariance(kInertia, kInertia), alone.covariance(kInertia, kInertia));
}

TEST(JointRefinement, FindsTheOffsetOfTheCamerasClock) {
  for (const double offset : {-0.13, 0.2}) {
    const SyntheticCameraRun run = Synthesize({.dof = Dof::kYaw,
                                               .input = InputKind::kMultisine,
                                               .duration = 60.0,
                                               .clock_offset = offset});
    const JointSummary summary = FitJoint(run.input, {.clock_offset_std = 1.0});
    ExpectFound(summary, run, 0.02);
    EXPECT_NEAR(
        summary.segments[0].clock_offset, offset, 4.0 * summary.segments[0].clock_offset_std);
    EXPECT_LT(summary.segments[0].clock_offset_std, 0.02);
    EXPECT_GT(summary.segments[0].clock_offset_std, 0.0);
  }
}

TEST(JointRefinement, RefusesWhatItCannotUse) {
  SyntheticCameraRun run = Synthesize({.duration = 5.0});
  JointInput input = run.input;
  input.segments[0].detections[0][0].tag_id = 77;
  EXPECT_THROW(FitJoint(input), InputError);
  input = run.input;
  input.segments[0].time.pop_back();
  EXPECT_THROW(FitJoint(input), InputError);
  EXPECT_THROW(FitJoint(run.input, {.loss_limit = 0.0}), InputError);
}

}  // namespace
}  // namespace fathom
