// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// A vehicle that rolls against a righting moment: named where it tilts far, and not told from a
// linear spring where it hardly tilts.

#include "fathom/diagnosis/diagnosis.h"
#include "fathom/synthesize/synthesize.h"
#include "fathom/vehicle/effects/catalogue.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "named.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::Contains;

constexpr UncoupledModel<double> kRollTruth = {0.35, 0.3, 1.0, 0.0};

// A small vehicle under a moment in roll of this size [N m], with an effect of this amount hidden.
Log RollLog(const std::string& effect, double amount, double size, std::uint64_t seed) {
  Vehicle vehicle;
  vehicle.name = "rolling";
  vehicle.models[Index(Dof::kRoll)] = kRollTruth;
  Experiment experiment;
  experiment.name = "rolling";
  experiment.duration = 60.0;
  experiment.command_rate = 10.0;
  MultisineInput sines;
  sines.rms = size;
  sines.lowest_frequency = 0.2;
  sines.highest_frequency = 3.0;
  sines.num_lines = 12;
  experiment.drives = {{.dof = Dof::kRoll, .input = {0.0, sines}, .pid = {}}};
  experiment.velocity.emplace();
  experiment.velocity->sampling.rate = 10.0;
  experiment.velocity->noise[Index(Dof::kRoll)] = 0.01;
  experiment.pose.emplace();
  experiment.pose->sampling.rate = 10.0;
  experiment.pose->angle_noise = 0.005;
  const std::vector<ActiveEffect> hidden = {{FindEffect(effect), {.dof = Dof::kRoll}, {amount}}};
  return Synthesize(vehicle, experiment, hidden, seed);
}

Diagnosis DiagnosedRoll(const Log& log) {
  return Diagnose(std::span<const Log>(&log, 1), Dof::kRoll);
}

// Largest roll angle of the log, either way [rad]; about the x axis alone.
double LargestRoll(const Log& log) {
  double largest = 0.0;
  const auto &x = *log.pose->Find("qx"), &w = *log.pose->Find("qw");
  for (std::size_t i = 0; i < x.size(); ++i) {
    largest = std::max(largest, 2.0 * std::atan2(std::abs(x[i]), std::abs(w[i])));
  }
  return largest;
}

TEST(RightingMoment, IsNamedAloneWhereTheVehicleTiltsFar) {
  const Log log = RollLog("righting_moment", 1.2, 1.1, 1);
  EXPECT_GT(LargestRoll(log), 1.7);
  EXPECT_LT(LargestRoll(log), 2.5);
  const Diagnosis diagnosis = DiagnosedRoll(log);
  EXPECT_EQ(TextOf(diagnosis), "explained: righting_moment");
  ASSERT_EQ(diagnosis.extended.model.effects.size(), 1u);
  const double std = std::sqrt(diagnosis.extended.covariance.diagonal()[kNumParameters]);
  EXPECT_LT(std, 0.02);
  EXPECT_NEAR(diagnosis.extended.model.effects[0].values[0], 1.2, 4.0 * std);
}

TEST(RightingMoment, IsNotNamedForASpringThatIsLinearFarOut) {
  const Log log = RollLog("position_stiffness", 0.8, 1.1, 2);
  EXPECT_GT(LargestRoll(log), 1.3);
  EXPECT_EQ(TextOf(DiagnosedRoll(log)), "explained: position_stiffness");
}

// Up to 0.3 rad sin x differs from x by less than x^3 / 6 = 0.005, the noise of one sample.
TEST(RightingMoment, IsNotToldFromASpringAtSmallAngles) {
  const Log log = RollLog("righting_moment", 1.2, 0.1, 3);
  EXPECT_LT(LargestRoll(log), 0.3);
  const Diagnosis diagnosis = DiagnosedRoll(log);
  const auto groups = GroupsOf(diagnosis);
  ASSERT_EQ(groups.size(), 1u);
  EXPECT_THAT(groups[0].members, Contains("righting_moment"));
  EXPECT_THAT(groups[0].members, Contains("position_stiffness"));
  EXPECT_THAT(groups[0].experiment, ::testing::HasSubstr("more than a radian"));
}

}  // namespace
}  // namespace fathom
