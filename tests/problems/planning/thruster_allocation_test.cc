// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/thruster_allocation.h"

#include "fathom/base/input_error.h"

#include <cmath>
#include <string>
#include <vector>

#include "error_from.h"
#include <Eigen/Geometry>
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;

Vehicle HeavyRov() { return ReadVehicleFile(FATHOM_DATA_DIR "/vehicles/bluerov2_heavy.yaml"); }

Vehicle VehicleWith(const std::string& thrusters) {
  return ParseVehicleFile("rov.yaml", "name: rov\nthrusters:\n" + thrusters);
}

std::string Refusal(const AllocationTask& task, const Vehicle& vehicle) {
  return ErrorFrom([&] { AllocateAlong(task, vehicle, "rov.yaml"); });
}

// The wrench about the origin, thruster by thruster.
struct Wrench {
  Eigen::Vector3d force = Eigen::Vector3d::Zero(), moment = Eigen::Vector3d::Zero();
};
Wrench WrenchOf(const Vehicle& vehicle, const std::vector<double>& thrusts) {
  Wrench wrench;
  for (std::size_t k = 0; k < thrusts.size(); ++k) {
    const Eigen::Vector3d force = thrusts[k] * vehicle.thrusters[k].direction;
    wrench.force += force;
    wrench.moment += vehicle.thrusters[k].position.cross(force);
  }
  return wrench;
}

// Four at 45 degrees share the force: 1 / (4 cos 45). They sit 0.085 m below the origin, which the
// four verticals, 0.12 m before and behind it, make up for: 0.085 / (4 x 0.12).
TEST(ThrusterAllocation, IsTheClosedFormOfAVectoredFrame) {
  const Vehicle vehicle = HeavyRov();
  const ThrusterAllocation surge = AllocateAlong({Dof::kSurge, {16.0}}, vehicle, "rov.yaml");
  const double level = 0.25 * std::sqrt(2.0), upright = 0.085 / 0.48;
  const std::vector<double> expected = {
      -level, -level, level, level, upright, upright, -upright, -upright};
  ASSERT_EQ(surge.share.size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) {
    EXPECT_NEAR(surge.share[k], expected[k], 1e-6) << surge.thrusters.names[k];
  }
  // A T200 gives 39.9 N backward at 16 V, and 51.5 N ahead: two of four go backward either way.
  EXPECT_NEAR(surge.reach.high, 39.9 / level, 1e-3);
  EXPECT_NEAR(surge.reach.low, -39.9 / level, 1e-3);
  EXPECT_EQ(surge.roll, 0.0);
  EXPECT_EQ(surge.pitch, 0.0);
}

TEST(ThrusterAllocation, GivesItsForceAndNoOther) {
  const Vehicle vehicle = HeavyRov();
  for (const Dof dof : kAllDofs) {
    const ThrusterAllocation allocation = AllocateAlong({dof, {14.3}}, vehicle, "rov.yaml");
    const Wrench wrench = WrenchOf(vehicle, allocation.ThrustsOf(-7.3));
    Eigen::Matrix<double, 6, 1> expected = Eigen::Matrix<double, 6, 1>::Zero();
    expected[Index(dof)] = -7.3;
    EXPECT_LT((wrench.force - expected.head<3>()).norm(), 1e-5) << Name(dof);
    EXPECT_LT((wrench.moment - expected.tail<3>()).norm(), 1e-5) << Name(dof);
  }
}

// Of two side by side, the one further out gives less; they are the only ones that hold the yaw.
TEST(ThrusterAllocation, HoldsTheYawOfALopsidedPair) {
  const Vehicle vehicle = VehicleWith(
      "  - {name: port, position: [-0.4, -0.45, 0], direction: [1, 0, 0]}\n"
      "  - {name: starboard, position: [-0.4, 0.3, 0], direction: [1, 0, 0]}\n");
  const ThrusterAllocation surge = AllocateAlong({Dof::kSurge}, vehicle, "rov.yaml");
  EXPECT_NEAR(surge.share[0], 0.4, 1e-12);
  EXPECT_NEAR(surge.share[1], 0.6, 1e-12);
  EXPECT_TRUE(std::isinf(surge.reach.high));
  EXPECT_FALSE(surge.thrusters.HasPulses());
  const ThrusterAllocation limited =
      AllocateAlong({Dof::kSurge, {.thruster_force = 30.0}}, vehicle, "rov.yaml");
  EXPECT_NEAR(limited.ReachEachWay(), 50.0, 1e-9);
}

// What they cannot hold, the vehicle has to right itself.
TEST(ThrusterAllocation, TellsThePitchThatItCannotHold) {
  const ThrusterAllocation surge = AllocateAlong(
      {Dof::kSurge},
      VehicleWith("  - {name: port, position: [0, -0.2, 0.3], direction: [1, 0, 0]}\n"
                  "  - {name: starboard, position: [0, 0.2, 0.3], direction: [1, 0, 0]}\n"),
      "rov.yaml");
  EXPECT_NEAR(surge.pitch, 0.3, 1e-12);
  EXPECT_EQ(surge.roll, 0.0);
}

TEST(ThrusterAllocation, GivesPulsesThatGiveTheThrusts) {
  const Vehicle vehicle = HeavyRov();
  const ThrusterAllocation yaw = AllocateAlong({Dof::kYaw, {16.0}}, vehicle, "rov.yaml");
  ASSERT_TRUE(yaw.thrusters.HasPulses());
  const std::vector<double> thrusts = yaw.ThrustsOf(6.1);
  const std::vector<int> pulses = yaw.thrusters.PulsesOf(thrusts);
  for (std::size_t k = 0; k < thrusts.size(); ++k) {
    // Half a microsecond of the table's steepest part, 8.1 N over 40 us.
    EXPECT_NEAR(vehicle.thrust_tables[0].Thrust(pulses[k], 16.0), thrusts[k], 0.5 * 8.1 / 40.0);
  }
  EXPECT_THAT(yaw.thrusters.PulsesOf(yaw.ThrustsOf(0.0)), ::testing::Each(1500));
}

TEST(ThrusterAllocation, RefusesWhatTheThrustersCannotGive) {
  const std::string port = "  - {name: port, position: [0, -0.2, 0], direction: [1, 0, 0]}\n";
  EXPECT_THAT(
      Refusal({Dof::kSurge}, VehicleWith(port)),
      HasSubstr("rov.yaml: its thrusters give surge a force of 0 N without yaw: 0.2 N m act "
                "along it for each N."));
  EXPECT_THAT(Refusal({Dof::kSway}, VehicleWith(port)),
              HasSubstr("rov.yaml: its thrusters give sway a force of 0 N,"));
  EXPECT_THAT(Refusal({Dof::kSurge}, ParseVehicleFile("rov.yaml", "name: rov\n")),
              HasSubstr("rov.yaml: has no thrusters"));
}

TEST(ThrusterAllocation, AsksForTheVoltageOfItsTables) {
  EXPECT_THAT(
      Refusal({Dof::kSurge}, HeavyRov()),
      HasSubstr("--voltage: is missing, expected the volts of the supply, since table 'T200' "
                "of rov.yaml holds 12, 16, 20 V."));
  EXPECT_THAT(Refusal({Dof::kSurge, {24.0}}, HeavyRov()),
              HasSubstr("--voltage: is 24 V, expected 12 to 20 V as in table 'T200' of rov.yaml."));
}

}  // namespace
}  // namespace fathom
