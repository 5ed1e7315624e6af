// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/ladder.h"

#include <random>
#include <string>
#include <vector>

#include "drawn_vehicle.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::UnorderedElementsAre;

std::vector<std::string> NamesIn(const Ladder& ladder) {
  std::vector<std::string> names;
  for (const NamedEntry& named : ladder.named) names.push_back(NameOf(named.entry));
  return names;
}

Ladder LadderOf(const CoupledModel& truth, std::mt19937* random) {
  DrawnLogOptions options;
  options.duration = 100.0;
  CoupledLogs logs;
  logs.data = {DrawnLog(truth, options, random)};
  return ClimbLadder(logs, truth.dofs, {});
}

TEST(ClimbLadder, NamesTheCouplingsThatAreThere) {
  std::mt19937 random(1002);
  CoupledModel truth = DrawnPlanarVehicle(&random);
  truth.inertia(0, 5) = truth.inertia(5, 0) = -1.9;
  truth.linear_damping(1, 5) = -1.5;
  const Ladder ladder = LadderOf(truth, &random);
  EXPECT_THAT(NamesIn(ladder),
              UnorderedElementsAre("inertia.surge.yaw", "linear_damping.sway.yaw"));
  const LadderRung& accepted = ladder.rungs[ladder.accepted];
  EXPECT_TRUE(accepted.structure.coriolis);
  EXPECT_NEAR(accepted.fit.model.inertia(0, 5), -1.9, 0.15);
  EXPECT_NEAR(accepted.fit.model.linear_damping(1, 5), -1.5, 0.5);
}

// A compass that stands 6 degrees askew in the vehicle.
TEST(ClimbLadder, NamesAThrustThatIsTurnedAgainstTheVelocity) {
  std::mt19937 random(1004);
  CoupledModel truth = DrawnPlanarVehicle(&random);
  truth.thrust_angle = 0.1;
  const Ladder ladder = LadderOf(truth, &random);
  EXPECT_THAT(NamesIn(ladder), UnorderedElementsAre("thrust_angle"));
  EXPECT_NEAR(ladder.rungs[ladder.accepted].fit.model.thrust_angle, 0.1, 0.01);
}

TEST(ClimbLadder, NamesNothingWhereNothingIs) {
  std::mt19937 random(1001);
  CoupledModel truth = DrawnPlanarVehicle(&random);
  truth.coriolis = false;
  const Ladder ladder = LadderOf(truth, &random);
  EXPECT_EQ(ladder.rungs[ladder.accepted].name, "diagonal");
  EXPECT_TRUE(ladder.named.empty());
}

}  // namespace
}  // namespace fathom
