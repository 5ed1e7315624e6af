// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/coupled/coupled_start.h"

#include <cstddef>

#include "plain_simulator.h"
#include "test_rov.h"
#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace fathom {
namespace {

constexpr double kRate = 10.0;              // of the samples [Hz]
constexpr std::size_t kSamplesOfStep = 20;  // of the command
constexpr std::size_t kAtAStep = 3 * kSamplesOfStep;

// What a second simulator does under five steps, measured without noise.
CoupledData PlainRun() {
  CoupledData data;
  data.dofs = Rov().dofs;
  data.inputs = Steps(5);
  CoupledSegment segment;
  PlainSimulator plain(Rov());
  for (std::size_t k = 0; k < 5 * kSamplesOfStep; ++k) {
    segment.time.push_back(static_cast<double>(k) / kRate);
    segment.velocity.push_back(plain.nu);
    segment.pose_time.push_back(segment.time.back());
    segment.attitude.emplace_back(plain.world_from_body);
    segment.position.push_back(plain.position);
    plain.Advance(ForceOf(Rov(), data.inputs, k / kSamplesOfStep), 1.0 / kRate, 1e-3);
  }
  data.segments = {segment};
  return data;
}

TEST(FittedCoupledStart, IsTheStateWhereTheMotionBends) {
  const CoupledData data = PlainRun();
  const CoupledSegment& segment = data.segments.front();
  const Vector6& truth = segment.velocity[kAtAStep];
  const CoupledState fitted = FittedCoupledStart(Rov(), data, segment, kAtAStep);
  EXPECT_LT((fitted.nu - truth).norm(), 1e-4);
  EXPECT_GT((MeasuredState(segment, kAtAStep).nu - truth).norm(), 1e-2);
}

TEST(FittedCoupledStart, HeedsNoSampleThatIsFarOff) {
  CoupledData data = PlainRun();
  CoupledSegment& segment = data.segments.front();
  const Vector6 truth = segment.velocity[kAtAStep];
  segment.velocity[kAtAStep + 4][0] += 1.0;
  EXPECT_LT((FittedCoupledStart(Rov(), data, segment, kAtAStep).nu - truth).norm(), 1e-3);
}

TEST(FittedCoupledStart, IsAsMeasuredWhereTheRunDiverges) {
  const CoupledData data = PlainRun();
  const CoupledSegment& segment = data.segments.front();
  CoupledModel impossible = Rov();
  impossible.inertia.setZero();
  EXPECT_EQ(FittedCoupledStart(impossible, data, segment, kAtAStep).nu,
            MeasuredState(segment, kAtAStep).nu);
}

}  // namespace
}  // namespace fathom
