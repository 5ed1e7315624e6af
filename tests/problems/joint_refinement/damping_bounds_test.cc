// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// The joint problem where the corners ask for less damping than none.

#include "fathom/joint_refinement/problem/joint_problem.h"

#include <cmath>
#include <vector>

#include "camera_experiment.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

// A short run of heave and the joint problem under processes that are not searched.
struct Problem {
  SyntheticCameraRun run;
  JointData data;
  ProcessSet processes;
  GlobalsPrior prior;

  // A camera whose stamps are off makes the vehicle appear to be damped less, or more.
  explicit Problem(double clock_offset)
      : run(Synthesize({.dof = Dof::kHeave,
                        .duration = 60.0,
                        .rate = 5.0,
                        .clock_offset = clock_offset,
                        .seed = 3})) {
    const CameraSegment& camera = run.input.segments[0];
    data.setup = {run.input.camera, run.input.body_from_camera};
    data.excited = Index(Dof::kHeave);
    data.segments.push_back(
        {camera.detections,
         run.input.map,
         PredictedMotion(camera.command, camera.time, data.excited, {1.0, 0.3, 0.1})});
    processes.corner_sigma = 0.3;
    for (int j = 0; j < kNumHeld; ++j) processes.wander[j] = {j < 2 ? 0.01 : 0.002, 0.5, 1.0};
    for (int i = kSizeColumn; i < kNumShared; ++i) prior.std[i] = 0.0;
    prior.std[kClockColumn] = 0.0;
  }

  // From the poses of the frames and a guess of the model.
  JointUnknowns Start(const UncoupledModel<double>& guess) {
    const CameraSegment& camera = run.input.segments[0];
    JointUnknowns unknowns;
    unknowns.model = {
        std::log(guess.inertia), guess.quadratic_damping, guess.linear_damping, guess.buoyancy};
    unknowns.segments.resize(1);
    EXPECT_TRUE(data.segments[0].motion.Update(unknowns.Motion(0)));
    SegmentUnknowns& own = unknowns.segments[0];
    own.rate.resize(camera.time.size());
    for (size_t k = 0; k < camera.time.size(); ++k) {
      own.deviation.emplace_back();
      PoseVector::Map(own.deviation[k].data()) =
          VectorFromPose(camera.world_from_body[k]) - data.segments[0].motion.Mean(k);
    }
    return unknowns;
  }

  // The least cost with the linear damping held at this value: its profile.
  double Profile(double linear_damping, JointUnknowns from) {
    from.model[kLinearDamping] = linear_damping;
    GlobalsPrior held = prior;
    held.std[kLinearDamping] = 0.0;
    const BoundedSolve solve = SolveJoint(&data, processes, {held}, {}, &from);
    EXPECT_TRUE(solve.converged) << solve.message;
    return solve.cost;
  }
};

// Where the least of a parabola through the profile is.
double LeastOfProfile(Problem* problem, const JointUnknowns& from) {
  constexpr double kStep = 5.0;  // a quarter of the damping's standard deviation
  const double below = problem->Profile(-kStep, from), middle = problem->Profile(0.0, from),
               above = problem->Profile(kStep, from);
  return 0.5 * kStep * (below - above) / (below - 2.0 * middle + above);
}

TEST(DampingBounds, HoldExactlyWhereTheProfileOfTheCostRises) {
  int held = 0, free = 0;
  double factor = 0.7;
  // From far on either side to where the bound is hardly touched.
  for (const double clock_offset : {-0.1, 0.08, 0.0872, 0.0874, 0.0876, 0.15}) {
    Problem problem(clock_offset);
    UncoupledModel<double> guess = problem.run.truth;
    guess.inertia *= factor;
    guess.quadratic_damping /= factor;
    guess.linear_damping = 100.0 * (factor - 1.0);  // every other time below 0
    factor = 1.0 / factor;
    JointUnknowns unknowns = problem.Start(guess);
    const BoundedSolve solve =
        SolveJoint(&problem.data, problem.processes, {problem.prior}, {}, &unknowns);
    ASSERT_TRUE(solve.converged) << clock_offset << " s: " << solve.message;
    EXPECT_GT(unknowns.model[kQuadraticDamping], 0.0);
    const double found = unknowns.model[kLinearDamping];
    const double least = LeastOfProfile(&problem, unknowns);
    // Costs of some 1700, right to 1e-8 and bent by 1/20^2, put the parabola's least where it is
    // to 0.01, if that is near 0; its sign is right anywhere.
    if (least < -0.1) {
      EXPECT_EQ(solve.held, std::vector<int>{kLinearDamping}) << least;
      EXPECT_EQ(found, 0.0);
      ++held;
    } else if (least > 0.1) {
      EXPECT_TRUE(solve.held.empty()) << least;
      EXPECT_LT(solve.cost, problem.Profile(found + 2.0, unknowns));
      EXPECT_LT(solve.cost, problem.Profile(found - 2.0, unknowns));
      ++free;
    } else {
      EXPECT_GE(found, 0.0);
      EXPECT_NEAR(found, 0.0, 0.2);
    }
  }
  EXPECT_GE(held, 2);
  EXPECT_GE(free, 2);
}

}  // namespace
}  // namespace fathom
