// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/files/vehicle_file.h"

#include <string>

#include "error_from.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;

constexpr char kHead[] = "name: rov\nmass: 22.5\nsize: [0.7, 0.5, 0.3]\n";

constexpr char kThrusters[] =
    "thrusters:\n"
    "  - {name: port, position: [-0.2, -0.3, 0.05], direction: [1, 0, 0],\n"
    "     coefficient: {forward: 0.04, reverse: 0.03}}\n"
    "  - {name: lift, position: [0.1, 0, 0], direction: [0, 0, -1],\n"
    "     coefficient: {forward: 0.02, reverse: 0}}\n";

std::string Error(const std::string& text) {
  return ErrorFrom([&] { ParseVehicleFile("v.yaml", text); });
}

TEST(VehicleFile, ReadsAVehicleWithThrustersAndModels) {
  const Vehicle vehicle = ParseVehicleFile(
      "v.yaml",
      std::string(kHead) + kThrusters +
          "models:\n"
          "  surge: {inertia: 40, quadratic_damping: 30, linear_damping: 5, buoyancy: -0.5}\n"
          "  yaw: {inertia: 2, quadratic_damping: 1.5, linear_damping: 0}\n");
  EXPECT_EQ(vehicle.name, "rov");
  EXPECT_EQ(vehicle.mass, 22.5);
  EXPECT_EQ(vehicle.size, Eigen::Vector3d(0.7, 0.5, 0.3));
  ASSERT_EQ(vehicle.thrusters.size(), 2u);
  EXPECT_EQ(vehicle.thrusters[0].name, "port");
  EXPECT_EQ(vehicle.thrusters[0].position, Eigen::Vector3d(-0.2, -0.3, 0.05));
  EXPECT_EQ(vehicle.thrusters[1].direction, Eigen::Vector3d(0, 0, -1));
  EXPECT_EQ(vehicle.thrusters[0].forward_coefficient, 0.04);
  EXPECT_EQ(vehicle.thrusters[0].reverse_coefficient, 0.03);
  EXPECT_EQ(vehicle.models[0]->inertia, 40.0);
  EXPECT_EQ(vehicle.models[0]->quadratic_damping, 30.0);
  EXPECT_EQ(vehicle.models[0]->linear_damping, 5.0);
  EXPECT_EQ(vehicle.models[0]->buoyancy, -0.5);
  EXPECT_EQ(vehicle.models[5]->quadratic_damping, 1.5);
  EXPECT_EQ(vehicle.models[5]->buoyancy, 0.0);
  EXPECT_FALSE(vehicle.models[2].has_value());
}

TEST(VehicleFile, NeedsNeitherThrustersNorModels) {
  const Vehicle vehicle = ParseVehicleFile("v.yaml", kHead);
  EXPECT_TRUE(vehicle.thrusters.empty());
  for (const auto& model : vehicle.models) EXPECT_FALSE(model.has_value());
}

TEST(VehicleFile, LeavesMassAndSizeOpenWhereItDoesNotKnowThem) {
  const Vehicle vehicle = ParseVehicleFile("v.yaml", "name: rov\n");
  EXPECT_FALSE(vehicle.mass);
  EXPECT_FALSE(vehicle.size);
}

TEST(VehicleFile, ReadsTheInertiasThatItKnows) {
  const Vehicle vehicle = ParseVehicleFile("v.yaml", "name: a\ninertia: {surge: 40, yaw: 5.45}\n");
  EXPECT_EQ(vehicle.inertia[Index(Dof::kSurge)], 40.0);
  EXPECT_EQ(vehicle.inertia[Index(Dof::kYaw)], 5.45);
  EXPECT_FALSE(vehicle.inertia[Index(Dof::kSway)].has_value());
}

TEST(VehicleFile, ReadsTheBody) {
  const Vehicle vehicle =
      ParseVehicleFile("v.yaml",
                       "name: rov\nmass: 20\nrigid_body:\n"
                       "  inertia_tensor: [[1, 0, 0.1], [0, 2, 0], [0.1, 0, 2.5]]\n"
                       "  centre_of_mass: [0, 0, 0.05]\n"
                       "  volume: 0.0201\n"
                       "  centre_of_buoyancy: [0, 0, -0.02]\n");
  EXPECT_EQ(vehicle.body.mass, 20.0);
  ASSERT_TRUE(RigidInertia(vehicle.body));
  EXPECT_EQ((*RigidInertia(vehicle.body))(3, 5), 0.1);
  EXPECT_EQ((*RigidInertia(vehicle.body))(0, 4), 20.0 * 0.05);
  EXPECT_EQ(vehicle.body.volume, 0.0201);
  EXPECT_EQ(vehicle.body.centre_of_buoyancy, Eigen::Vector3d(0, 0, -0.02));
}

TEST(VehicleFile, ReadsFins) {
  const Vehicle vehicle = ParseVehicleFile(
      "v.yaml",
      std::string(kHead) +
          "fins:\n"
          "  - {name: rudder, position: [-3.5, 0, 0.3], axis: [0, 0, 1], area: 0.05,\n"
          "     lift_slope: 2.5, behind: propeller}\n"
          "  - {name: port_plane, position: [-3, -1, 0], axis: [0, -1, 0]}\n");
  ASSERT_EQ(vehicle.fins.size(), 2u);
  EXPECT_EQ(vehicle.fins[0].behind, "propeller");
  EXPECT_DOUBLE_EQ(*FinForceOf(vehicle.fins[0]), 0.5 * 1000.0 * 0.05 * 2.5);
  EXPECT_EQ(AcrossFin(vehicle.fins[0]), Eigen::Vector3d(0, 1, 0));
  EXPECT_FALSE(FinForceOf(vehicle.fins[1]));
  EXPECT_EQ(AcrossFin(vehicle.fins[1]), Eigen::Vector3d(0, 0, 1));
}

TEST(VehicleFile, ReadsShafts) {
  const Vehicle vehicle = ParseVehicleFile(
      "v.yaml",
      std::string(kHead) +
          "shafts:\n"
          "  - {name: port, position: [-3.4, -1, 0.3], diameter: 0.2, thrust: {linear: [0.36, "
          "-0.4]},\n"
          "     wake: 0.4, thrust_deduction: 0.25}\n"
          "  - {name: starboard, position: [-3.4, 1, 0.3], diameter: 0.3,\n"
          "     thrust: {table: [[0, 0.4], [0.5, 0.2], [0.8, 0.05]]}}\n"
          "  - {name: bare, position: [0, 0, 0], diameter: 0.1}\n"
          "  - {name: tug, position: [0, 0, 0], diameter: 0.1, thrust: {bollard: 0.3}}\n");
  ASSERT_EQ(vehicle.shafts.size(), 4u);
  EXPECT_TRUE(vehicle.shafts[0].IsThrustKnown());
  EXPECT_EQ(vehicle.shafts[0].position, Eigen::Vector3d(-3.4, -1, 0.3));
  // J = 0.6 * 2 / (8 * 0.2) = 0.75, K_T = 0.06.
  EXPECT_NEAR(
      ShaftThrustAt(vehicle.shafts[0], 8.0, 2.0).thrust, 1000.0 * 64.0 * 0.0016 * 0.06, 1e-10);
  EXPECT_FALSE(vehicle.shafts[1].IsThrustKnown());  // the thrust deduction is not stated
  EXPECT_EQ(vehicle.shafts[1].curve->thrust[2], 0.05);
  EXPECT_FALSE(vehicle.shafts[2].curve);
  EXPECT_NEAR(
      ShaftThrustAt(vehicle.shafts[3], 10.0, 5.0).thrust, 1000.0 * 100.0 * 1e-4 * 0.3, 1e-12);
}

TEST(VehicleFile, RefusesAShaftThatCannotBe) {
  const auto error = [](const std::string& more) {
    return Error(std::string(kHead) + "shafts:\n  - {name: a, position: [0, 0, 0], " + more +
                 "}\n");
  };
  EXPECT_THAT(error("diameter: 0"), HasSubstr("is 0, expected a number above 0"));
  EXPECT_THAT(error("diameter: 1, wake: 1"), HasSubstr("is 1, expected a share between -1 and 1"));
  EXPECT_THAT(error("diameter: 1, thrust: {bollard: -0.1}"), HasSubstr("K_T at rest is -0.1"));
  EXPECT_THAT(error("diameter: 1, thrust: {linear: [0.3, 0.1]}"), HasSubstr("K_1 below 0"));
  EXPECT_THAT(error("diameter: 1, thrust: {table: [[0.1, 0.3], [0.5, 0.1]]}"),
              HasSubstr("the first with J = 0"));
  EXPECT_THAT(error("diameter: 1, thrust: {table: [[0, 0.3], [0.5, 0.1], [0.5, 0]]}"),
              HasSubstr("J does not increase"));
  EXPECT_THAT(error("diameter: 1, thrust: {}"), HasSubstr("expected one of"));
  EXPECT_THAT(error("diameter: 1}\n  - {name: a, position: [0, 0, 0], diameter: 1"),
              HasSubstr("is that of another shaft or thruster"));
}

TEST(VehicleFile, RefusesAFinThatCannotBe) {
  const auto error = [](const std::string& fin) {
    return Error(std::string(kHead) + "fins:\n  - {" + fin + "}\n");
  };
  EXPECT_THAT(error("name: a, position: [0, 0, 0], axis: [1, 0, 0]"), HasSubstr("is along x"));
  EXPECT_THAT(error("name: a, position: [0, 0, 0], axis: [0, 2, 0]"), HasSubstr("has length 2"));
  EXPECT_THAT(error("name: a, position: [0, 0, 0], axis: [0, 1, 0], area: -1"), HasSubstr("area"));
}

TEST(VehicleFile, RefusesATensorOfNoBody) {
  const auto message = [](const std::string& tensor) {
    return Error(
        "name: rov\nmass: 20\nrigid_body:\n  centre_of_mass: [0, 0, 0]\n"
        "  inertia_tensor: " +
        tensor + "\n");
  };
  EXPECT_THAT(message("[[1, 0, 0], [0, 1, 0], [0, 0, 2.5]]"), HasSubstr("of no body"));
  EXPECT_THAT(message("[[1, 0.2, 0], [0, 1, 0], [0, 0, 1.5]]"), HasSubstr("not symmetric"));
  EXPECT_THAT(message("[[1, 0, 0], [0, 1, 0]]"), HasSubstr("2 rows"));
}

TEST(VehicleFile, RefusesWhatCannotBeAVehicle) {
  EXPECT_EQ(Error("name: a\ninertia: {yaw: 0}\n"),
            "v.yaml:2: key 'inertia.yaw' is 0, expected a number above 0.");
  EXPECT_EQ(Error("name: a\nmass: -2\nsize: [1, 1, 1]\n"),
            "v.yaml:2: key 'mass' is -2, expected a number above 0.");
  EXPECT_EQ(
      Error("name: a\nmass: 2\nsize: [1, 0, 1]\n"),
      "v.yaml:3: key 'size' holds a number that is not above 0, expected length, width, height.");
  EXPECT_EQ(Error("name: a\nmass: 2\nsize: [1, 1]\n"),
            "v.yaml:3: key 'size' is a list of 2, expected a list of 3 numbers.");
  EXPECT_EQ(Error(std::string(kHead) + "weight: 3\n"),
            "v.yaml:4: key 'weight' is not known here, expected one of: name, mass, size, "
            "inertia, rigid_body, thrust_tables, thrusters, fins, shafts, "
            "models, coupled_model. Correct or remove it.");
}

TEST(VehicleFile, RefusesAThrusterThatCannotBe) {
  const auto error = [](const std::string& direction, const std::string& coefficient) {
    return Error(std::string(kHead) +
                 "thrusters:\n  - name: a\n    position: [0, 0, 0]\n    direction: " + direction +
                 "\n    coefficient: " + coefficient + "\n");
  };
  EXPECT_EQ(
      error("[1, 1, 0]", "{forward: 1, reverse: 1}"),
      "v.yaml:7: key 'thrusters[0].direction' has length 1.41421, expected a unit vector (within "
      "0.001).");
  EXPECT_EQ(error("[0, 0, 0]", "{forward: 1, reverse: 1}"),
            "v.yaml:7: key 'thrusters[0].direction' has length 0, expected a unit vector (within "
            "0.001).");
  EXPECT_EQ(error("[0.70711, -0.70711, 0]", "{forward: 1, reverse: 1}"), "no error");
  EXPECT_EQ(error("[1, 0, 0]", "{forward: 0, reverse: 1}"),
            "v.yaml:8: key 'thrusters[0].coefficient.forward' is 0, expected a number above 0.");
  EXPECT_EQ(
      error("[1, 0, 0]", "{forward: 1, reverse: -1}"),
      "v.yaml:8: key 'thrusters[0].coefficient.reverse' is -1, expected a number of at least 0.");
  EXPECT_EQ(error("[1, 0, 0]", "0.04"),
            "v.yaml:8: key 'thrusters[0].coefficient' is '0.04', expected a map.");
}

TEST(VehicleFile, RefusesAModelThatCannotBe) {
  const auto error = [](const std::string& model) {
    return Error(std::string(kHead) + "models:\n  heave: " + model + "\n");
  };
  EXPECT_EQ(error("{inertia: 0, quadratic_damping: 1, linear_damping: 1}"),
            "v.yaml:5: key 'models.heave.inertia' is 0, expected a number above 0.");
  EXPECT_EQ(
      error("{inertia: 1, quadratic_damping: -1, linear_damping: 1}"),
      "v.yaml:5: key 'models.heave.quadratic_damping' is -1, expected a number of at least 0.");
  EXPECT_EQ(error("{inertia: 1, quadratic_damping: 1}"),
            "v.yaml:5: key 'models.heave.linear_damping' is missing, expected a finite number.");
  EXPECT_EQ(
      Error(std::string(kHead) + "models: {forward: {}}\n"),
      "v.yaml:4: key 'models.forward' is not known here, expected one of: surge, sway, heave, "
      "roll, pitch, yaw. Correct or remove it.");
}

TEST(VehicleFile, RefusesPartsOfOneName) {
  const std::string thrusters = std::string(kHead) + kThrusters;
  EXPECT_EQ(Error(thrusters + "  - {name: port, position: [0, 0, 0], direction: [1, 0, 0]}\n"),
            "v.yaml:9: key 'thrusters[2].name' is that of another thruster, expected each name "
            "once.");
  const std::string fin = "  - {name: top, position: [-1, 0, 0], axis: [0, 0, 1]}\n";
  EXPECT_THAT(Error(std::string(kHead) + "fins:\n" + fin + fin),
              HasSubstr("key 'fins[1].name' is that of another fin"));
  const std::string table =
      "  - {name: T, command: us, voltages: [12], thrust: [[1, 0], [2, 1]]}\n";
  EXPECT_THAT(Error(std::string(kHead) + "thrust_tables:\n" + table + table),
              HasSubstr("key 'thrust_tables[1].name' is that of another thrust table"));
}

}  // namespace
}  // namespace fathom
