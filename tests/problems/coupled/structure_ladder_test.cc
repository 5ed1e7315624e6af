// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/structure_ladder.h"

#include "fathom/vehicle/coupled/entry_name.h"

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

TEST(ClimbLadder, NamesALagOfTheThrusters) {
  std::mt19937 random(1005);
  CoupledModel truth = DrawnPlanarVehicle(&random);
  truth.thruster_lag = 0.4;
  const Ladder ladder = LadderOf(truth, &random);
  EXPECT_THAT(NamesIn(ladder), UnorderedElementsAre("thruster_lag"));
  EXPECT_NEAR(ladder.rungs[ladder.accepted].fit.model.thruster_lag, 0.4, 0.05);
}

// The clock of the command runs 0.3 s ahead of that of the motion.
TEST(ClimbLadder, NamesACommandThatComesLate) {
  std::mt19937 random(1006);
  const CoupledModel truth = DrawnPlanarVehicle(&random);
  DrawnLogOptions options;
  options.duration = 100.0;
  CoupledLogs logs;
  logs.data = {DrawnLog(truth, options, &random)};
  for (double& t : logs.data.front().inputs.command.time) t -= 0.3;
  const Ladder ladder = ClimbLadder(logs, truth.dofs, {});
  EXPECT_THAT(NamesIn(ladder), UnorderedElementsAre("time_offset"));
  EXPECT_NEAR(ladder.rungs[ladder.accepted].fit.model.time_offset, 0.3, 0.03);
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
