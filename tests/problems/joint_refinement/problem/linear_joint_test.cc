// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/problem/linear_joint.h"

#include "fathom/solve/decompositions.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "random_segment.h"
#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace fathom {
namespace {

// One dense system over all states and globals.
struct DenseSystem {
  explicit DenseSystem(int num_frames)
      : num_frames(num_frames),
        g(12 * num_frames),
        H(Eigen::MatrixXd::Zero(g + kNumColumns, g + kNumColumns)),
        b(Eigen::VectorXd::Zero(g + kNumColumns)) {}

  int num_frames;
  int g;  // where the globals begin
  Eigen::MatrixXd H;
  Eigen::VectorXd b;
};

void AddCorners(const LinearSegment& segment, const ProcessSet& set, DenseSystem* system) {
  const int g = system->g;
  const double w = 1.0 / (set.corner_sigma * set.corner_sigma);
  for (int k = 0; k < system->num_frames; ++k) {
    const LinearFrame& frame = segment.frames[k];
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) system->H(12 * k + 2 * i, 12 * k + 2 * j) += w * frame.JdJd(i, j);
      system->H.block(12 * k + 2 * i, g, 1, kNumColumns) += w * frame.JdJg.row(i);
      system->H.block(g, 12 * k + 2 * i, kNumColumns, 1) += w * frame.JdJg.row(i).transpose();
      system->b[12 * k + 2 * i] += w * frame.Jdr[i];
    }
  }
  system->H.block(g, g, kNumColumns, kNumColumns) += w * segment.JgJg;
  system->b.tail(kNumColumns) += w * segment.Jgr;
}

void AddChain(const LinearSegment& segment,
              const ProcessSet& set,
              int excited,
              DenseSystem* system) {
  for (int i = 0, slot = 0; i < 6; ++i) {
    const SecondOrderProcess process = i == excited ? set.ModelError() : set.Wander(slot++);
    for (int k = 0; k < system->num_frames; ++k) {
      const int at = 12 * k + 2 * i;
      if (!process.IsPresent()) {
        system->H(at, at) += 1e14;
        system->H(at + 1, at + 1) += 1e14;
        continue;
      }
      if (k == 0) {
        system->H.block<2, 2>(at, at) += i == excited
                                             ? Eigen::Matrix2d(1e12 * Eigen::Matrix2d::Identity())
                                             : process.StationaryCovariance().inverse();
      }
      if (k + 1 == system->num_frames) continue;
      const Transition t = process.Over(segment.durations[segment.duration_after[k]]);
      Eigen::Matrix<double, 2, 4> M;
      M << -t.Phi, Eigen::Matrix2d::Identity();
      const Eigen::Matrix4d block = M.transpose() * t.Q.inverse() * M;
      system->H.block<2, 2>(at, at) += block.topLeftCorner<2, 2>();
      system->H.block<2, 2>(at, at + 12) += block.topRightCorner<2, 2>();
      system->H.block<2, 2>(at + 12, at) += block.bottomLeftCorner<2, 2>();
      system->H.block<2, 2>(at + 12, at + 12) += block.bottomRightCorner<2, 2>();
    }
  }
}

void AddResponsePriors(const ProcessSet& set, DenseSystem* system) {
  const int g = system->g;
  for (int column = 0; column < kNumColumns; ++column) {
    if (!IsResponse(column)) continue;
    const double std = std::max(NoResponseStd(0.02), set.response_std[HeldSlot(column)]);
    system->H(g + column, g + column) += 1.0 / (std * std);
    system->b[g + column] += 0.02 / (std * std);
  }
}

TEST(LinearJoint, AgreesWithDenseAlgebra) {
  const std::vector<LinearSegment> segments = {RandomSegment(9)};
  const std::vector<GlobalsPrior> priors(1);
  const ProcessSet set = SomeProcesses();
  const int excited = 1;
  const LinearJoint joint(segments, priors, set, excited);
  ASSERT_TRUE(joint.is_usable());

  DenseSystem system(9);
  AddCorners(segments[0], set, &system);
  AddChain(segments[0], set, excited, &system);
  AddResponsePriors(set, &system);
  const Eigen::VectorXd x = -SolveSymmetric(system.H, system.b);
  const Eigen::MatrixXd inverse = InverseOfSymmetric(system.H);
  EXPECT_LT((joint.change(0) - x.tail(kNumColumns)).norm(), 1e-6 * x.tail(kNumColumns).norm());
  EXPECT_TRUE(
      joint.covariance(0).isApprox(inverse.bottomRightCorner(kNumColumns, kNumColumns), 1e-5));
  const auto deviations = joint.Deviations(0);
  for (int k = 0; k < system.num_frames; ++k) {
    EXPECT_LT((deviations[k] - x.segment<12>(12 * k)).norm(), 1e-6) << k;
  }
  // Second moments of coordinate 4 over its first step.
  const SegmentMoments moments = joint.Moments(0);
  const Eigen::Vector2d s0 = x.segment<2>(8);
  const Eigen::Matrix2d expected = s0 * s0.transpose() + inverse.block<2, 2>(8, 8);
  EXPECT_TRUE(moments.first[4].isApprox(expected, 1e-5));
}

// The same segment, linearised where the response's coefficient of this index is another.
LinearSegment WithResponse(LinearSegment segment, int index, double coefficient) {
  const int column = kResponseColumns + index;
  const double change = coefficient - segment.response[index];
  for (LinearFrame& frame : segment.frames) frame.Jdr += change * frame.JdJg.col(column);
  segment.rr += 2.0 * change * segment.Jgr[column] + change * change * segment.JgJg(column, column);
  segment.Jgr += change * segment.JgJg.col(column);
  segment.response[index] = coefficient;
  return segment;
}

// However small, and however far from where the corners would have it: what is left without it is
// what a linearisation without it says.
TEST(LinearJoint, TakesAResponseAwayWhole) {
  const std::vector<GlobalsPrior> priors(1);
  ProcessSet set = SomeProcesses();
  set.response_std.fill(0.0);
  for (const double size : {1e-7, 1e-5, 1e-3, 0.1}) {
    std::vector<LinearSegment> with = {RandomSegment(9)}, without = {RandomSegment(9)};
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

}  // namespace
}  // namespace fathom
