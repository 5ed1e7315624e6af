// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_planning/wrench_allocation.h"

#include "fathom/coupled_planning/plan_coupled.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "boat_trial.h"
#include "error_from.h"
#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;

const std::vector<Dof> kSurgeSwayYaw = {Dof::kSurge, Dof::kSway, Dof::kYaw};

// Four T200 at 45 degrees and four verticals.
Vehicle EightThrusters() {
  return ReadVehicleFile(FATHOM_DATA_DIR "/vehicles/bluerov2_heavy.yaml");
}

// A column for each thruster, about the origin.
Eigen::MatrixXd PushesOf(const Vehicle& vehicle) {
  Eigen::MatrixXd pushes(6, vehicle.thrusters.size());
  for (Eigen::Index k = 0; k < pushes.cols(); ++k) {
    const Thruster& thruster = vehicle.thrusters[static_cast<std::size_t>(k)];
    pushes.col(k) << thruster.direction, thruster.position.cross(thruster.direction);
  }
  return pushes;
}

Eigen::VectorXd AsVector(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

// Of all thrusts that give the wrench and nothing else.
TEST(WrenchAllocation, IsTheShortestThatGivesTheWrench) {
  const Vehicle vehicle = EightThrusters();
  const WrenchAllocation allocation =
      AllocateWrench(kSurgeSwayYaw, {16.0}, {}, vehicle, "rov.yaml");
  Vector6 wrench = Vector6::Zero();
  wrench << 17.0, -9.0, 0.0, 0.0, 0.0, 2.3;
  const Eigen::MatrixXd pushes = PushesOf(vehicle);
  const Eigen::VectorXd expected =
      pushes.jacobiSvd(Eigen::ComputeThinU | Eigen::ComputeThinV).solve(wrench);
  EXPECT_LT((AsVector(allocation.ThrustsOf(wrench)) - expected).norm(), 1e-5);
}

// A thruster that gives 0.7 of what it is told, and one that gives nothing.
TEST(WrenchAllocation, MakesUpForTheGainsOfAModel) {
  const Vehicle vehicle = EightThrusters();
  const WrenchAllocation allocation =
      AllocateWrench(kSurgeSwayYaw,
                     {16.0},
                     {{"front_port", 0.7}, {"rear_port_vertical", 0.0}},
                     vehicle,
                     "rov.yaml");
  Vector6 wrench = Vector6::Zero();
  wrench << 17.0, -9.0, 0.0, 0.0, 0.0, 2.3;
  const std::vector<double> thrusts = allocation.ThrustsOf(wrench);
  EXPECT_EQ(thrusts[7], 0.0);
  Eigen::VectorXd given = AsVector(thrusts);
  given[1] *= 0.7;
  EXPECT_LT((PushesOf(vehicle) * given - wrench).norm(), 1e-5);
}

// Each of these alone takes all that one of the level four gives backward at 16 V, 39.9 N.
TEST(WrenchAllocation, GivesLessOnEachAxisWhereSeveralAreDriven) {
  const Vehicle vehicle = EightThrusters();
  const WrenchAllocation allocation =
      AllocateWrench(kSurgeSwayYaw, {16.0}, {}, vehicle, "rov.yaml");
  Vector6 wrench = Vector6::Zero();
  wrench[0] = 39.9 * 4.0 * std::sqrt(0.5) - 1e-3;
  EXPECT_TRUE(allocation.Gives(wrench));
  wrench[1] = 1.0;
  EXPECT_FALSE(allocation.Gives(wrench));
  wrench[1] = 0.0;
  wrench[0] += 2e-3;
  EXPECT_FALSE(allocation.Gives(wrench));
}

// Surge pitches a vehicle whose thrusters sit low: one cannot command both.
TEST(WrenchAllocation, RefusesADofThatCannotBeDrivenWithoutAnother) {
  const Vehicle low =
      ParseVehicleFile("rov.yaml",
                       "name: rov\nthrusters:\n"
                       "  - {name: port, position: [0, -0.2, 0.3], direction: [1, 0, 0]}\n"
                       "  - {name: starboard, position: [0, 0.2, 0.3], direction: [1, 0, 0]}\n");
  EXPECT_THAT(ErrorFrom([&] {
                AllocateWrench({Dof::kSurge, Dof::kPitch}, {}, {}, low, "rov.yaml");
              }),
              HasSubstr("rov.yaml: its thrusters give pitch 0.3 N m for each N of surge, expected "
                        "DOFs that they drive one without the other"));
  EXPECT_EQ(AllocateWrench({Dof::kSurge, Dof::kYaw}, {}, {}, low, "rov.yaml").along[0].pitch, 0.3);
}

// 40 N ahead, 40 N aside and 8 N m at once would take a multiple of 20 N of a thruster.
TEST(PlanCoupled, TakesNoMoreOfAThrusterThanItGives) {
  const Vehicle vehicle = EightThrusters();
  CoupledPlanRequest request = BoatRequest(DrawBoat(41), 20.0, 0.1);
  request.vehicle = &vehicle;
  request.vehicle_name = "rov.yaml";
  request.voltage = 16.0;
  request.limits.thruster_force = 20.0;
  const CoupledPlan plan = PlanCoupledExperiment(request);
  ASSERT_TRUE(plan.IsUsable()) << plan.message;
  const Eigen::MatrixXd pushes = PushesOf(vehicle);
  const auto greatest = [&](const CoupledCommand& command) {
    double most = 0.0;
    for (const Vector6& wrench : command.force) {
      const Eigen::VectorXd thrusts =
          pushes.jacobiSvd(Eigen::ComputeThinU | Eigen::ComputeThinV).solve(wrench);
      most = std::max(most, thrusts.cwiseAbs().maxCoeff());
    }
    return most;
  };
  EXPECT_LT(greatest(plan.command), 20.0 + 1e-4);
  EXPECT_GT(greatest(plan.command), 15.0);
  EXPECT_LT(greatest(plan.sine), 20.0 + 1e-4);
  bool drives_all = false;
  for (const Vector6& wrench : plan.command.force) {
    drives_all = drives_all || (wrench[0] != 0.0 && wrench[1] != 0.0 && wrench[5] != 0.0);
  }
  EXPECT_TRUE(drives_all);
}

TEST(PlanCoupled, RefusesWhatTheThrustersCannotGive) {
  const Vehicle vehicle = EightThrusters();
  CoupledPlanRequest request = BoatRequest(DrawBoat(41), 20.0, 0.1);
  request.vehicle = &vehicle;
  request.vehicle_name = "rov.yaml";
  request.voltage = 16.0;
  const auto refusal = [&] { return ErrorFrom([&] { PlanCoupledExperiment(request); }); };
  request.limits.thruster_force = 10.0;  // four of them at 45 degrees
  EXPECT_EQ(refusal(),
            "lake.yaml: key 'force.surge' is 40 N, expected at most 28.284: the thrusters of "
            "rov.yaml give surge -28.28 to 28.28 N.");
  request.limits.thruster_force = 28.0;  // of which 40 N ahead and aside take 28.3
  request.model.model.thrust_gain["stern"] = 0.9;
  EXPECT_EQ(refusal(),
            "rov.yaml: has no thruster 'stern', expected the vehicle of boat.json, which holds its "
            "gain.");
  request.model.model.thrust_gain.clear();
  request.model.model.offset.head<2>() << 40.0, 40.0;
  EXPECT_THAT(refusal(),
              HasSubstr("rov.yaml: its thrusters cannot give at once what holds the vehicle where "
                        "it is, 40, 40, 0, 0, 0, "));
}

}  // namespace
}  // namespace fathom
