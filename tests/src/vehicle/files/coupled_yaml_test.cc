// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/files/vehicle_file.h"

#include <string>

#include "error_from.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr char kHull[] =
    "name: rov\n"
    "mass: 20\n"
    "rigid_body: {inertia_tensor: [[1, 0, 0], [0, 2, 0], [0, 0, 2]], centre_of_mass: [0, 0, 0.1]}\n"
    "fins:\n"
    "  - {name: rudder, position: [-0.6, 0, 0], axis: [0, 0, 1]}\n"
    "  - {name: plane, position: [-0.6, 0, 0], axis: [0, 1, 0], area: 0.02, lift_slope: 3}\n"
    "thrusters:\n"
    "  - {name: port, position: [0, -0.2, 0], direction: [1, 0, 0]}\n";

constexpr char kModel[] =
    "coupled_model:\n"
    "  added_mass: [5, 12, 15, 0.1, 0.2, 0.3]\n"
    "  linear_damping: [4, 6, 7, 0.5, 0.6, 0.7]\n";

std::string ErrorOf(const std::string& text) {
  return ErrorFrom([&] { ParseVehicleFile("v.yaml", text); });
}

TEST(CoupledYaml, AddsAddedMassToTheRigidBody) {
  const Vehicle vehicle = ParseVehicleFile("v.yaml", std::string(kHull) + kModel);
  ASSERT_TRUE(vehicle.coupled);
  const CoupledModel& model = *vehicle.coupled;
  EXPECT_EQ(model.dofs.size(), 6u);
  EXPECT_TRUE(model.coriolis);
  EXPECT_EQ(model.inertia(0, 0), 25.0);
  EXPECT_EQ(model.inertia(1, 1), 32.0);
  EXPECT_DOUBLE_EQ(model.inertia(4, 4), 2.2);
  // -m S(r_g): m z_g along surge by pitch, -m z_g along sway by roll.
  EXPECT_DOUBLE_EQ(model.inertia(0, 4), 2.0);
  EXPECT_DOUBLE_EQ(model.inertia(4, 0), 2.0);
  EXPECT_DOUBLE_EQ(model.inertia(1, 3), -2.0);
  EXPECT_EQ(model.linear_damping(5, 5), 0.7);
  EXPECT_EQ(model.linear_damping(0, 1), 0.0);
  EXPECT_EQ(model.net_buoyancy, 0.0);
}

TEST(CoupledYaml, ReadsWholeMatricesAndAllOtherNumbers) {
  const Vehicle vehicle =
      ParseVehicleFile("v.yaml",
                       std::string(kHull) +
                           "coupled_model:\n"
                           "  dofs: [yaw, surge, sway]\n"
                           "  coriolis: false\n"
                           "  inertia:\n"
                           "    - [30, 0, 0, 0, 0, 0]\n"
                           "    - [0, 40, 0, 0, 0, 3]\n"
                           "    - [0, 0, 0, 0, 0, 0]\n"
                           "    - [0, 0, 0, 0, 0, 0]\n"
                           "    - [0, 0, 0, 0, 0, 0]\n"
                           "    - [0, 3, 0, 0, 0, 8]\n"
                           "  quadratic_damping:\n"
                           "    - [9, 0, 0, 0, 0, 0]\n"
                           "    - [0, 8, 0, 0, 0, 1.5]\n"
                           "    - [0, 0, 0, 0, 0, 0]\n"
                           "    - [0, 0, 0, 0, 0, 0]\n"
                           "    - [0, 0, 0, 0, 0, 0]\n"
                           "    - [0, -2.5, 0, 0, 0, 7]\n"
                           "  lift: [0, 11, 0, 0, 0, 0]\n"
                           "  offset: [1, 2, 0, 0, 0, 6]\n"
                           "  thrust_gain: {port: 0.8}\n"
                           "  fin_force: {rudder: 9.6}\n"
                           "  fin_race: {rudder: 0.2}\n"
                           "  fin_neutral: {plane: 0.01}\n  fin_stuck: {plane: 0.2}\n");
  const CoupledModel& model = *vehicle.coupled;
  EXPECT_THAT(model.dofs, ElementsAre(Dof::kSurge, Dof::kSway, Dof::kYaw));
  EXPECT_FALSE(model.coriolis);
  EXPECT_EQ(model.inertia(1, 5), 3.0);
  EXPECT_EQ(model.quadratic_damping(1, 5), 1.5);
  EXPECT_EQ(model.quadratic_damping(5, 1), -2.5);
  EXPECT_EQ(model.lift(1, 1), 11.0);
  EXPECT_EQ(model.offset[5], 6.0);
  EXPECT_EQ(model.thrust_gain.at("port"), 0.8);
  EXPECT_EQ(model.fin_force.at("rudder"), 9.6);
  // rho/2 A dC_L/dangle = 500 * 0.02 * 3, in fresh water.
  EXPECT_NEAR(model.fin_force.at("plane"), 30.0, 0.1);
  EXPECT_EQ(model.fin_race.at("rudder"), 0.2);
  EXPECT_EQ(model.fin_neutral.at("plane"), 0.01);
  EXPECT_EQ(model.fin_stuck.at("plane"), 0.2);
}

TEST(CoupledYaml, ReadsWeightAndBuoyancy) {
  const CoupledModel model =
      *ParseVehicleFile("v.yaml",
                        std::string(kHull) + kModel +
                            "  net_buoyancy: 2.5\n  righting_moment: {roll: 6, pitch: 7}\n")
           .coupled;
  EXPECT_EQ(model.net_buoyancy, 2.5);
  EXPECT_EQ(model.righting_roll, 6.0);
  EXPECT_EQ(model.righting_pitch, 7.0);
}

TEST(CoupledYaml, RefusesNumbersThatNoModelledDofFeels) {
  const std::string surge = std::string(kHull) + kModel + "  dofs: [surge]\n";
  EXPECT_EQ(
      ErrorOf(surge + "  offset: [1, 0, 0, 0, 0, 9]\n"),
      "v.yaml:13: key 'coupled_model.offset' is 9 along yaw, which is none of 'dofs', so that "
      "it has no effect. Expected 0.");
  EXPECT_THAT(ErrorOf(surge + "  righting_moment: {roll: 2}\n"),
              HasSubstr("righting_moment' is 2 of roll, which is none of 'dofs'"));
  EXPECT_THAT(ErrorOf(surge + "  net_buoyancy: 5\n"),
              HasSubstr("net_buoyancy' is 5, but none of heave, roll and pitch is one of 'dofs'"));
  EXPECT_THAT(ErrorOf(surge + "  effects: {coulomb_friction.sway: 3}\n"),
              HasSubstr("effects.coulomb_friction.sway' acts along none of 'dofs'"));
  EXPECT_EQ(ErrorOf(surge + "  offset: [1, 0, 0, 0, 0, 0]\n  righting_moment: {roll: 0}\n"
                            "  effects: {coulomb_friction.surge: 3, thrust_dead_zone: 1}\n"),
            "no error");
}

TEST(CoupledYaml, ReadsEffectsByTheNamesOfTheirEntries) {
  const std::string hull = std::string(kHull) + kModel;
  const CoupledModel model =
      *ParseVehicleFile("v.yaml",
                        hull + "  effects: {coulomb_friction.yaw: 0.4, thrust_dead_zone: 1.5}\n")
           .coupled;
  EXPECT_EQ(model.effects.at("coulomb_friction")[5], 0.4);
  EXPECT_EQ(model.thruster_effects.at("thrust_dead_zone"), 1.5);
  EXPECT_THAT(ErrorOf(hull + "  effects: {stiction.yaw: 0.4}\n"),
              HasSubstr("stiction.yaw' is no effect of a coupled model"));
  EXPECT_THAT(ErrorOf(hull + "  effects: {coulomb_friction.yaw: -0.4}\n"),
              HasSubstr("coulomb_friction.yaw' is -0.4, expected 0 to inf"));
}

TEST(CoupledYaml, ReadsTheLimitedRateOfAFin) {
  const std::string hull = std::string(kHull) + kModel;
  const CoupledModel model =
      *ParseVehicleFile("v.yaml", hull + "  fin_rate_limit: {rudder: 0.1}\n").coupled;
  EXPECT_EQ(model.fin_rate_limit.at("rudder"), 0.1);
  EXPECT_THAT(ErrorOf(hull + "  fin_rate_limit: {rudder: 0}\n"),
              HasSubstr("key 'coupled_model.fin_rate_limit' of rudder is 0 rad/s, expected a rate "
                        "above 0 rad/s."));
  EXPECT_THAT(ErrorOf(hull + "  fin_lag: {rudder: 1}\n  fin_rate_limit: {rudder: 0.1}\n"),
              HasSubstr("key 'coupled_model.fin_rate_limit' of rudder stands beside its 'fin_lag', "
                        "expected one of them."));
}

TEST(CoupledYaml, ReadsTheAngleOfAttackAtWhichAFinStalls) {
  const std::string hull = std::string(kHull) + kModel;
  const CoupledModel model =
      *ParseVehicleFile("v.yaml", hull + "  fin_stall: {rudder: 0.3}\n").coupled;
  EXPECT_EQ(model.fin_stall.at("rudder"), 0.3);
  EXPECT_THAT(ErrorOf(hull + "  fin_stall: {rudder: 17}\n"),
              HasSubstr("key 'coupled_model.fin_stall' of rudder is 17 rad, expected an angle of "
                        "attack above 0 and below pi/2 rad."));
}

TEST(CoupledYaml, RefusesAMatrixOfAnotherShape) {
  const std::string hull = kHull;
  EXPECT_THAT(ErrorOf(hull + "coupled_model:\n  inertia: [1, 2, 3]\n"),
              HasSubstr("v.yaml:10: key 'coupled_model.inertia'"));
  EXPECT_EQ(ErrorOf(hull + "coupled_model:\n  inertia: [[1, 0, 0, 0, 0, 0], [0, 2, 0, 0, 0, 0]]\n"),
            "v.yaml:10: key 'coupled_model.inertia' has 2 rows, expected 6 of 6 numbers each, or "
            "the 6 on the diagonal.");
}

TEST(CoupledYaml, RefusesAnInertiaThatCannotBe) {
  const std::string hull = kHull;
  EXPECT_EQ(ErrorOf(hull + "coupled_model:\n  inertia: [[9, 1, 0, 0, 0, 0], [2, 9, 0, 0, 0, 0],\n"
                           "    [0, 0, 9, 0, 0, 0], [0, 0, 0, 9, 0, 0], [0, 0, 0, 0, 9, 0],\n"
                           "    [0, 0, 0, 0, 0, 9]]\n"),
            "v.yaml:10: key 'coupled_model.inertia' is 2 in row 2, column 1, but 1 in row 1, "
            "column 2, expected a symmetric matrix.");
  EXPECT_THAT(ErrorOf(hull + "coupled_model:\n  inertia: [9, 9, 9, 0, 9, 9]\n"),
              HasSubstr("v.yaml:10: key 'coupled_model.inertia' gives an inertia that is not "
                        "positive definite"));
  EXPECT_THAT(ErrorOf(hull + "coupled_model:\n  linear_damping: [1, 1, 1, 1, 1, 1]\n"),
              HasSubstr("holds neither 'inertia' nor 'added_mass'"));
  EXPECT_THAT(ErrorOf(hull + kModel + "  inertia: [9, 9, 9, 9, 9, 9]\n"),
              HasSubstr("v.yaml:10: key 'coupled_model.added_mass' stands beside 'inertia'"));
  EXPECT_THAT(ErrorOf("name: rov\nmass: 20\ncoupled_model:\n  added_mass: [1, 1, 1, 1, 1, 1]\n"),
              HasSubstr("v.yaml:4: key 'coupled_model.added_mass' needs the body"));
}

TEST(CoupledYaml, RefusesDampingThatGivesEnergy) {
  const std::string inertia =
      std::string(kHull) + "coupled_model:\n  inertia: [9, 9, 9, 9, 9, 9]\n";
  EXPECT_THAT(ErrorOf(inertia + "  linear_damping: [1, 1, -1, 1, 1, 1]\n"),
              HasSubstr("v.yaml:11: key 'coupled_model.linear_damping' gives energy"));
  EXPECT_THAT(ErrorOf(inertia + "  quadratic_damping: [1, 1, 1, 1, -18.2, 1]\n"),
              HasSubstr("v.yaml:11: key 'coupled_model.quadratic_damping' is -18.2 along pitch, "
                        "expected at least 0"));
}

TEST(CoupledYaml, RefusesNamesThatTheFileDoesNotHold) {
  const std::string model = std::string(kHull) + kModel;
  EXPECT_THAT(ErrorOf(model + "  dofs: [surge, ahead]\n"),
              HasSubstr("v.yaml:12: key 'coupled_model.dofs' holds 'ahead', expected surge, sway"));
  EXPECT_THAT(ErrorOf(model + "  dofs: [surge, surge]\n"), HasSubstr("twice"));
  EXPECT_THAT(
      ErrorOf(model + "  thrust_gain: {starboard: 0.5}\n"),
      HasSubstr("v.yaml:12: key 'coupled_model.thrust_gain.starboard' is no thruster or shaft of "
                "this file"));
  EXPECT_THAT(ErrorOf(model + "  fin_force: {sail: 2}\n"), HasSubstr("is no fin of this file"));
  EXPECT_THAT(ErrorOf(model + "  mass: 2\n"), HasSubstr("'coupled_model.mass' is not known here"));
  EXPECT_THAT(ErrorOf(model + "models: {surge: {inertia: 1, quadratic_damping: 1, "
                              "linear_damping: 1}}\n"),
              HasSubstr("v.yaml:9: key 'coupled_model' stands beside 'models'"));
}

}  // namespace
}  // namespace fathom
