// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// A lagging sensor on a vehicle that is under way when its log begins: it shows what was before,
// and no second cause is to be named for that.

#include "fathom/diagnosis/diagnosis.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "named.h"
#include "surge_run.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using testing::Contains;
using testing::SizeIs;

constexpr double kTimeConstant = 1.2;  // [s]

// 120 s of a lagging sensor at 10 Hz, its first reading `start` seconds after the first command.
Diagnosis DiagnosedFrom(double start, int seed) {
  SurgeRun run;
  run.input = Multisine(120.0);
  run.duration = start + 120.0;
  run.velocity_noise = 0.005;
  run.effects = "sensor_lag:time_constant=1.2";
  const Log log = WithoutMotion(LogOf(run, static_cast<std::uint64_t>(seed)), 0.0, start);
  return Diagnose(std::span<const Log>(&log, 1), Dof::kSurge);
}

class LaggingStart : public testing::TestWithParam<int> {};

// Alone, or with the lag of the thrusters, which is the same in linear drag.
void ExpectTheLagAlone(const Diagnosis& diagnosis) {
  const std::vector<NamedGroup> groups = GroupsOf(diagnosis);
  ASSERT_THAT(groups, SizeIs(1)) << TextOf(diagnosis);
  EXPECT_THAT(groups[0].members, Contains("sensor_lag")) << TextOf(diagnosis);
  for (const std::string& member : groups[0].members) {
    EXPECT_THAT((std::set<std::string>{"sensor_lag", "thruster_lag"}), Contains(member));
  }
}

// By how many standard deviations the lag named is wrong.
double ErrorOfTheLag(const Diagnosis& diagnosis) {
  const double std = std::sqrt(diagnosis.extended.covariance(kNumParameters, kNumParameters));
  EXPECT_LT(std, 0.05);
  return (diagnosis.extended.model.effects.at(0).values[0] - kTimeConstant) / std;
}

TEST_P(LaggingStart, UnderWayNamesTheLagAlone) {
  const Diagnosis diagnosis = DiagnosedFrom(30.0, GetParam());
  ExpectTheLagAlone(diagnosis);
  EXPECT_LT(std::abs(ErrorOfTheLag(diagnosis)), 3.5);
  // The extended model misses on unseen blocks what the noise is: 0.8 of 5 mm/s.
  EXPECT_NEAR(diagnosis.extended.held_out.mae, 0.004, 0.001);
}

TEST_P(LaggingStart, AtRestNamesTheLagAlone) {
  const Diagnosis diagnosis = DiagnosedFrom(0.0, GetParam());
  ExpectTheLagAlone(diagnosis);
  EXPECT_LT(std::abs(ErrorOfTheLag(diagnosis)), 3.5);
}

INSTANTIATE_TEST_SUITE_P(Seeds, LaggingStart, testing::Range(1, 5));

}  // namespace
}  // namespace fathom
