// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/files/thruster_command.h"

#include "fathom/vehicle/files/thruster_shares.h"

#include <filesystem>
#include <fstream>
#include <string>

#include "error_from.h"
#include "test_folder.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Pair;

constexpr char kTwoThrusters[] =
    "name: rov\n"
    "thrusters:\n"
    "  - {name: port, position: [-0.2, -0.3, 0.05], direction: [1, 0, 0],\n"
    "     coefficient: {forward: 0.04, reverse: 0.03}}\n"
    "  - {name: lift, position: [0.1, 0, 0], direction: [0, 0, -1],\n"
    "     coefficient: {forward: 0.02, reverse: 0}}\n";

Vehicle TwoThrusters() { return ParseVehicleFile("v.yaml", kTwoThrusters); }

// port: 0.04 * 10^2 = 4 N ahead, 0.3 m to port and 0.05 m below the origin: pitch 0.05 * 4 = 0.2
// and yaw 0.3 * 4 = 1.2 N m. lift at 5 Hz: 0.5 N up, 0.1 m ahead: heave -0.5 N, pitch (p x d)_y =
// p_z d_x - p_x d_z = 0.1 * 0.5 = 0.05 N m. Reversed, port gives -0.03 * 4^2 = -0.48 N and lift
// nothing.
TEST(ThrusterForces, SumsForceAndMomentOfEachThrusterAtTheSameStamps) {
  const Stream command{.time = {3.0, 4.5},
                       .columns = {"thruster_2", "thruster_1"},
                       .values = {{5.0, -7.0}, {10.0, -4.0}}};
  const Stream forces = ForcesOfThrusts(ThrustsFromSpeeds(command, TwoThrusters()), TwoThrusters());
  EXPECT_THAT(forces.time, ElementsAre(3.0, 4.5));
  EXPECT_THAT(
      forces.columns,
      ElementsAre("tau_surge", "tau_sway", "tau_heave", "tau_roll", "tau_pitch", "tau_yaw"));
  const double expected[6][2] = {
      {4.0, -0.48}, {0.0, 0.0}, {-0.5, 0.0}, {0.0, 0.0}, {0.25, -0.024}, {1.2, -0.144}};
  for (int dof = 0; dof < 6; ++dof) {
    for (int row = 0; row < 2; ++row) {
      EXPECT_NEAR(forces.values[dof][row], expected[dof][row], 1e-14) << dof << " " << row;
    }
  }
}

TEST(ThrusterForces, RefusesAnotherNumberOfThrusters) {
  const auto error = [](const std::vector<std::string>& columns) {
    const Stream command{.time = {0.0},
                         .columns = columns,
                         .values = std::vector<std::vector<double>>(columns.size(), {1.0})};
    return ErrorFrom(
        [&] { ForcesOfThrusts(ThrustsFromSpeeds(command, TwoThrusters()), TwoThrusters()); });
  };
  EXPECT_EQ(error({"thruster_1"}),
            "command: column 'thruster_2' is missing, expected one for each of the 2 thrusters of "
            "vehicle "
            "'rov'.");
  EXPECT_EQ(error({"thruster_1", "thruster_2", "thruster_3"}),
            "command: holds 3 columns, expected one for each of the 2 thrusters of vehicle 'rov'. "
            "Is this "
            "the vehicle of the log?");
  EXPECT_EQ(error({"tau_surge", "tau_yaw"}),
            "command: column 'thruster_1' is missing, expected one for each of the 2 thrusters of "
            "vehicle "
            "'rov'.");
}

TEST(ThrusterForces, RefusesSpeedsThatGiveNoFiniteForce) {
  const Stream command{
      .time = {2.5}, .columns = {"thruster_1", "thruster_2"}, .values = {{1e200}, {0.0}}};
  EXPECT_EQ(
      ErrorFrom(
          [&] { ForcesOfThrusts(ThrustsFromSpeeds(command, TwoThrusters()), TwoThrusters()); }),
      "command: the thrusters at t = 2.5 give a force that is not finite, expected speeds in Hz or "
      "thrusts in N.");
}

TEST(ThrusterForces, NeedNoCoefficientWhereTheCommandIsInNewton) {
  const Vehicle vehicle =
      ParseVehicleFile("v.yaml",
                       "name: rov\nthrusters:\n"
                       "  - {name: port, position: [0, -0.5, 0], direction: [1, 0, 0]}\n"
                       "  - {name: starboard, position: [0, 0.5, 0], direction: [1, 0, 0]}\n");
  const Stream command{
      .time = {0.0}, .columns = {"thruster_1", "thruster_2"}, .values = {{3.0}, {1.0}}};
  const Stream forces = ForcesOfThrusts(command, vehicle);
  EXPECT_THAT(*forces.Find("tau_surge"), ElementsAre(4.0));
  EXPECT_THAT(*forces.Find("tau_yaw"), ElementsAre(1.0));
  EXPECT_THAT(ErrorFrom([&] { ThrustsFromSpeeds(command, vehicle); }),
              AllOf(HasSubstr("thruster 'port' of vehicle 'rov' has no coefficient"),
                    HasSubstr("`thruster_unit: N`")));
}

// Two thrusters side by side, the heading held: port turns 1.25 times as hard as starboard.
Log HeldHeading() {
  Log log;
  log.path = TestFolder();
  log.vehicle = "rov.yaml";
  std::ofstream(log.path / log.vehicle)
      << "name: rov\nthrusters:\n"
         "  - {name: port, position: [0, -0.5, 0], direction: [1, 0, 0]}\n"
         "  - {name: starboard, position: [0, 0.5, 0], direction: [1, 0, 0]}\n";
  log.thrusters = Stream{.time = {0.0, 1.0, 4.0, 5.0},
                         .columns = {"thruster_1", "thruster_2"},
                         .values = {{12.5, -25.0, 0.0, 0.0}, {10.0, -20.0, 0.0, 0.0}}};
  log.command = ForcesOfThrusts(*log.thrusters, *VehicleOf(log));
  return log;
}

TEST(ThrusterShares, AreTakenFromWhatWasCommanded) {
  EXPECT_THAT(ThrusterSharesOf(std::vector{HeldHeading()}, Dof::kSurge),
              ElementsAre(Pair("port", DoubleNear(1.25 / 2.25, 1e-12)),
                          Pair("starboard", DoubleNear(1.0 / 2.25, 1e-12))));
}

TEST(ThrusterShares, AreNotKnownOfForcesNorOfADofThatNothingPushes) {
  Log forces = HeldHeading();
  forces.thrusters.reset();
  EXPECT_TRUE(ThrusterSharesOf(std::vector{HeldHeading(), forces}, Dof::kSurge).empty());
  EXPECT_TRUE(ThrusterSharesOf(std::vector{HeldHeading()}, Dof::kHeave).empty());
}

}  // namespace
}  // namespace fathom
