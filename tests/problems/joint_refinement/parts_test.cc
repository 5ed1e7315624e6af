// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// The parts of the joint refinement against finite differences, dense algebra and Monte Carlo.

#include "fathom/joint_refinement/motion/predicted_motion.h"
#include "fathom/joint_refinement/problem/corner_rows.h"
#include "fathom/joint_refinement/problem/joint_problem.h"
#include "fathom/joint_refinement/problem/linear_joint.h"
#include "fathom/joint_refinement/processes/second_order_process.h"
#include "fathom/joint_refinement/search/process_likelihood.h"

#include <cmath>
#include <random>
#include <vector>

#include "camera_experiment.h"
#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(SecondOrderProcess, TwoStepsAreOneLongStep) {
  for (const auto& process : {SecondOrderProcess{0.7, 0.3, 2.0},     // weakly damped
                              SecondOrderProcess{0.16, 0.8, 2.0},    // critically
                              SecondOrderProcess{0.4, 40.0, 2.0},    // strongly
                              SecondOrderProcess{0.0, 0.2, 2.0}}) {  // free
    const Transition a = process.Over(0.13), b = process.Over(0.4), both = process.Over(0.53);
    EXPECT_TRUE(both.Phi.isApprox(b.Phi * a.Phi, 1e-10));
    EXPECT_TRUE(both.Q.isApprox(b.Phi * a.Q * b.Phi.transpose() + b.Q, 1e-6));
    const Eigen::Matrix2d I = a.whitener * a.Q * a.whitener.transpose();
    EXPECT_TRUE(I.isIdentity(1e-9));
    EXPECT_NEAR(a.log_det_Q, std::log(a.Q.determinant()), 1e-6);
  }
}

TEST(SecondOrderProcess, StaysAsLargeAsItIs) {
  const SecondOrderProcess process = SecondOrderProcess::Held(0.02, 0.8, 0.6);
  const Eigen::Matrix2d P = process.StationaryCovariance();
  EXPECT_NEAR(P(0, 0), 0.02 * 0.02, 1e-12);
  for (const double h : {0.1, 3.0, 60.0}) {
    const Transition t = process.Over(h);
    EXPECT_TRUE(P.isApprox(t.Phi * P * t.Phi.transpose() + t.Q, 1e-6)) << h;
  }
}

// Of a free particle: Q = q [h^3/3 h^2/2; h^2/2 h] as the damping vanishes.
TEST(SecondOrderProcess, IsTheWellKnownRandomWalkOfAVelocity) {
  const Transition t = SecondOrderProcess{0.0, 1e-9, 3.0}.Over(0.2);
  EXPECT_NEAR(t.Q(0, 0), 3.0 * 0.008 / 3.0, 1e-9);
  EXPECT_NEAR(t.Q(0, 1), 3.0 * 0.04 / 2.0, 1e-9);
  EXPECT_NEAR(t.Q(1, 1), 3.0 * 0.2, 1e-9);
}

TEST(CornerRows, AgreeWithDifferences) {
  const SyntheticCameraRun run = Synthesize({.num_markers = 4, .duration = 2.0});
  const CameraSetup setup = {run.input.camera, run.input.body_from_camera};
  const Detection& detection = run.input.runs[0].detections[3][2];
  PoseVector eta;
  eta << 0.1, -0.2, 0.15, 0.05, -0.07, 0.1;
  const SetupUnknowns unknowns = {1.02, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0}};
  const auto at = [&](const PoseVector& pose, const SetupUnknowns& u) {
    CornerRows rows;
    EXPECT_TRUE(EvaluateCorners(
        setup, u, *run.input.map.Find(detection.tag_id), detection, pose, 0.5, true, &rows));
    return rows;
  };
  const CornerRows rows = at(eta, unknowns);
  constexpr double kMove = 1e-6;
  for (int i = 0; i < 6; ++i) {
    PoseVector up = eta, down = eta;
    up[i] += kMove;
    down[i] -= kMove;
    const Eigen::Matrix<double, 8, 1> slope =
        (at(up, unknowns).residual - at(down, unknowns).residual) / (2.0 * kMove);
    EXPECT_LT((slope - rows.by_pose.col(i)).norm(), 1e-6 * (1.0 + slope.norm())) << i;
  }
  for (int i = 0; i < 7; ++i) {
    SetupUnknowns up = unknowns, down = unknowns;
    (i == 0 ? up.size_scale : up.mount[i - 1]) += kMove;
    (i == 0 ? down.size_scale : down.mount[i - 1]) -= kMove;
    const Eigen::Matrix<double, 8, 1> slope =
        (at(eta, up).residual - at(eta, down).residual) / (2.0 * kMove);
    EXPECT_LT((slope - rows.by_setup.col(i)).norm(), 1e-6 * (1.0 + slope.norm())) << i;
  }
}

TEST(PredictedMotion, AgreesWithDifferences) {
  HeldCommand command;
  std::vector<double> time;
  for (int i = 0; i < 200; ++i) {
    command.time.push_back(0.1 * i);
    command.value.push_back(30.0 * std::sin(0.05 * i));
    if (i > 3 && i < 180) time.push_back(0.1 * i + 0.037);
  }
  PredictedMotion motion(command, time, 2, {0.7, 0.2, 0.1});
  MotionUnknowns unknowns;
  unknowns.model = {std::log(120.0), 40.0, 15.0, 3.0};
  unknowns.start = {0.1, 0.4};
  for (int i = 0; i < kNumResponse; ++i) unknowns.response[i] = 0.01 * (i + 1);
  unknowns.clock_offset = 0.02;
  ASSERT_TRUE(motion.Update(unknowns));
  constexpr size_t kFrame = 150;
  const PredictedMotion::Derivatives D = motion.MeanDerivatives(kFrame);
  const auto differ = [&](auto move) {
    const double h = 1e-5;
    MotionUnknowns up = unknowns, down = unknowns;
    move(&up, h);
    move(&down, -h);
    EXPECT_TRUE(motion.Update(up));
    const PoseVector above = motion.Mean(kFrame);
    EXPECT_TRUE(motion.Update(down));
    return PoseVector((above - motion.Mean(kFrame)) / (2.0 * h));
  };
  const auto expect_column = [&](int column, const PoseVector& slope, double tolerance = 1e-6) {
    EXPECT_LT((D.col(column) - slope).norm(), tolerance * (1.0 + slope.norm())) << column;
  };
  for (int i = 0; i < kModelColumns; ++i) {
    expect_column(i, differ([&](MotionUnknowns* u, double h) { u->model[i] += h; }));
  }
  for (int i = 0; i < 2; ++i) {
    expect_column(kStartColumns + i,
                  differ([&](MotionUnknowns* u, double h) { u->start[i] += h; }));
  }
  for (int i = 0; i < kNumResponse; ++i) {
    expect_column(kResponseColumns + i,
                  differ([&](MotionUnknowns* u, double h) { u->response[i] += h; }));
  }
  // This one is of the exact solution, not of the numerical one.
  expect_column(
      kClockColumn, differ([&](MotionUnknowns* u, double h) { u->clock_offset += h; }), 1e-4);
}

// Without the model nothing ties the frames together: each gets the pose that fits its own corners
// best, as the experiment's own Gauss-Newton found it.
TEST(JointProblem, WithoutTheModelIsABundleAdjustment) {
  const SyntheticCameraRun run = Synthesize({.dof = Dof::kYaw, .num_markers = 4, .duration = 3.0});
  const CameraRun& camera = run.input.runs[0];
  JointData data;
  data.setup = {run.input.camera, run.input.body_from_camera};
  data.excited = Index(Dof::kYaw);
  data.runs.push_back({camera.detections,
                       run.input.map,
                       PredictedMotion(camera.command, camera.time, data.excited, MotionScales())});
  JointUnknowns unknowns;
  unknowns.model = {std::log(300.0), 200.0, 30.0, 0.0};
  unknowns.runs.resize(1);
  ASSERT_TRUE(data.runs[0].motion.Update(unknowns.Motion(0)));
  RunUnknowns& own = unknowns.runs[0];
  own.deviation.resize(camera.time.size());
  own.rate.resize(camera.time.size());
  for (size_t k = 0; k < camera.time.size(); ++k) {
    PoseVector moved = VectorFromPose(camera.world_from_body[k]) - data.runs[0].motion.Mean(k);
    moved += PoseVector(0.03, -0.02, 0.02, 0.01, -0.01, 0.02);
    PoseVector::Map(own.deviation[k].data()) = moved;
  }
  ProcessSet processes;
  processes.corner_sigma = 0.3;
  GlobalsPrior prior;  // clock, size and mount are known
  for (int i = kSizeColumn; i < kNumShared; ++i) prior.std[i] = 0.0;
  prior.std[kClockColumn] = 0.0;
  const JointSolve solve =
      SolveJoint(&data, processes, {prior}, {.without_model = true}, &unknowns);
  ASSERT_TRUE(solve.converged) << solve.message;
  for (size_t k = 0; k < camera.time.size(); ++k) {
    const PoseVector found = PoseAt(data.runs[0], own, k);
    const PoseVector alone = VectorFromPose(camera.world_from_body[k]);
    // Ceres stops where the cost, some 400, would fall by less than 1e-8 of itself: at three
    // thousandths of a pose's standard deviation, which is below a centimetre.
    EXPECT_LT((found - alone).norm(), 3e-5) << k;
  }
}

// A small chain with random rows.
LinearRun RandomRun(int num_frames) {
  std::mt19937 generator(5);
  std::normal_distribution<double> normal;
  LinearRun run;
  run.JgJg.setZero();
  run.Jgr.setZero();
  std::vector<double> time;
  for (int k = 0; k < num_frames; ++k) {
    time.push_back(0.1 * k + (k > 3 ? 0.5 : 0.0));
    Eigen::MatrixXd Jd(8, 6), Jg(8, kNumColumns);
    Eigen::VectorXd r(8);
    for (double& x : Jd.reshaped()) x = 30.0 * normal(generator);
    for (double& x : Jg.reshaped()) x = 20.0 * normal(generator);
    for (double& x : r) x = normal(generator);
    run.frames.push_back({Jd.transpose() * Jd, Jd.transpose() * Jg, Jd.transpose() * r});
    run.JgJg += Jg.transpose() * Jg;
    run.Jgr += Jg.transpose() * r;
    run.rr += r.squaredNorm();
    run.num_rows += 8.0;
  }
  run.response.setConstant(0.02);
  LayOutDurations(time, &run);
  return run;
}

ProcessSet SomeProcesses() {
  ProcessSet set;
  set.corner_sigma = 0.8;
  for (int j = 0; j < kNumHeld; ++j) {
    set.wander[j] = {0.02 + 0.01 * j, 0.5 + 0.1 * j, 0.4 + 0.3 * j};
  }
  set.wander[2].std = 0.0;
  set.response_std = {0.0, 0.03, 0.02, 0.0, 0.05};
  set.model_error = 1e-3;
  return set;
}

// The same problem as one dense system over all states and globals.
TEST(LinearJoint, AgreesWithDenseAlgebra) {
  const std::vector<LinearRun> runs = {RandomRun(9)};
  const std::vector<GlobalsPrior> priors(1);
  const ProcessSet set = SomeProcesses();
  const int excited = 1;
  const LinearJoint joint(runs, priors, set, excited);
  ASSERT_TRUE(joint.is_usable());

  const int n = 9, size = 12 * n + kNumColumns, g = 12 * n;
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(size);
  const double w = 1.0 / (set.corner_sigma * set.corner_sigma);
  for (int k = 0; k < n; ++k) {
    const LinearFrame& frame = runs[0].frames[k];
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) H(12 * k + 2 * i, 12 * k + 2 * j) += w * frame.JdJd(i, j);
      H.block(12 * k + 2 * i, g, 1, kNumColumns) += w * frame.JdJg.row(i);
      H.block(g, 12 * k + 2 * i, kNumColumns, 1) += w * frame.JdJg.row(i).transpose();
      b[12 * k + 2 * i] += w * frame.Jdr[i];
    }
  }
  H.block(g, g, kNumColumns, kNumColumns) += w * runs[0].JgJg;
  b.tail(kNumColumns) += w * runs[0].Jgr;
  for (int i = 0, slot = 0; i < 6; ++i) {
    const SecondOrderProcess process = i == excited ? set.ModelError() : set.Wander(slot++);
    for (int k = 0; k < n; ++k) {
      const int at = 12 * k + 2 * i;
      if (!process.IsPresent()) {
        H(at, at) += 1e14;
        H(at + 1, at + 1) += 1e14;
        continue;
      }
      if (k == 0) {
        H.block<2, 2>(at, at) += i == excited ? Eigen::Matrix2d(1e12 * Eigen::Matrix2d::Identity())
                                              : process.StationaryCovariance().inverse();
      }
      if (k + 1 == n) continue;
      const Transition t = process.Over(runs[0].durations[runs[0].duration_after[k]]);
      Eigen::Matrix<double, 2, 4> M;
      M << -t.Phi, Eigen::Matrix2d::Identity();
      const Eigen::Matrix4d block = M.transpose() * t.Q.inverse() * M;
      H.block<2, 2>(at, at) += block.topLeftCorner<2, 2>();
      H.block<2, 2>(at, at + 12) += block.topRightCorner<2, 2>();
      H.block<2, 2>(at + 12, at) += block.bottomLeftCorner<2, 2>();
      H.block<2, 2>(at + 12, at + 12) += block.bottomRightCorner<2, 2>();
    }
  }
  for (int column = 0; column < kNumColumns; ++column) {
    if (!IsResponse(column)) continue;
    const double std = std::max(NoResponseStd(0.02), set.response_std[HeldSlot(column)]);
    H(g + column, g + column) += 1.0 / (std * std);
    b[g + column] += 0.02 / (std * std);
  }
  const Eigen::LDLT<Eigen::MatrixXd> ldlt(H);
  const Eigen::VectorXd x = -ldlt.solve(b);
  const Eigen::MatrixXd inverse = ldlt.solve(Eigen::MatrixXd::Identity(size, size));
  EXPECT_LT((joint.change(0) - x.tail(kNumColumns)).norm(), 1e-6 * x.tail(kNumColumns).norm());
  EXPECT_TRUE(
      joint.covariance(0).isApprox(inverse.bottomRightCorner(kNumColumns, kNumColumns), 1e-5));
  const auto deviations = joint.Deviations(0);
  for (int k = 0; k < n; ++k) {
    EXPECT_LT((deviations[k] - x.segment<12>(12 * k)).norm(), 1e-6) << k;
  }
  // Second moments of coordinate 4 over its first step.
  const RunMoments moments = joint.Moments(0);
  const Eigen::Vector2d s0 = x.segment<2>(8);
  const Eigen::Matrix2d expected = s0 * s0.transpose() + inverse.block<2, 2>(8, 8);
  EXPECT_TRUE(moments.first[4].isApprox(expected, 1e-5));
}

// The same run, linearised where the response's coefficient of this index is another.
LinearRun WithResponse(LinearRun run, int index, double coefficient) {
  const int column = kResponseColumns + index;
  const double change = coefficient - run.response[index];
  for (LinearFrame& frame : run.frames) frame.Jdr += change * frame.JdJg.col(column);
  run.rr += 2.0 * change * run.Jgr[column] + change * change * run.JgJg(column, column);
  run.Jgr += change * run.JgJg.col(column);
  run.response[index] = coefficient;
  return run;
}

// However small, and however far from where the corners would have it: what is left without it is
// what a linearisation without it says.
TEST(LinearJoint, TakesAResponseAwayWhole) {
  const std::vector<GlobalsPrior> priors(1);
  ProcessSet set = SomeProcesses();
  set.response_std.fill(0.0);
  for (const double size : {1e-7, 1e-5, 1e-3, 0.1}) {
    std::vector<LinearRun> with = {RandomRun(9)}, without = {RandomRun(9)};
    for (int index = 0; index < kNumResponse; ++index) {
      if (index % kResponseTerms == 0) continue;  // the mean
      with[0] = WithResponse(with[0], index, index % 2 == 0 ? size : -0.3 * size);
      without[0] = WithResponse(without[0], index, 0.0);
    }
    const LinearJoint taken_away(with, priors, set, 1), none(without, priors, set, 1);
    ASSERT_TRUE(taken_away.is_usable() && none.is_usable());
    EXPECT_NEAR(taken_away.log_likelihood(), none.log_likelihood(), 1e-3) << size;
    for (int index = 0; index < kNumResponse; ++index) {
      if (index % kResponseTerms == 0) continue;
      const double left = with[0].response[index] + taken_away.change(0)[kResponseColumns + index];
      EXPECT_LT(std::abs(left), 1e-3 * size) << size;
    }
  }
}

TEST(ProcessLikelihood, HasTheSlopeOfItsValue) {
  const std::vector<LinearRun> runs = {RandomRun(40)};
  const std::vector<GlobalsPrior> priors(1);
  const ProcessParameters parameters(SomeProcesses());
  const ProcessLikelihood likelihood(runs, priors, parameters, 1);
  Eigen::VectorXd x = parameters.ToVector();
  x.array() += 0.1;
  const auto here = likelihood.At(x, true);
  ASSERT_TRUE(here.is_usable);
  for (int i = 0; i < parameters.size(); ++i) {
    constexpr double kMove = 1e-4;
    Eigen::VectorXd up = x, down = x;
    up[i] += kMove;
    down[i] -= kMove;
    const double slope =
        (likelihood.At(up, false).value - likelihood.At(down, false).value) / (2.0 * kMove);
    EXPECT_NEAR(here.slope[i], slope, 1e-3 * (1.0 + std::abs(slope))) << i;
  }
}

}  // namespace
}  // namespace fathom
