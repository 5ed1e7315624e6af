// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/exporting/stonefish.h"

#include "fathom/vehicle/coupled/entry_value.h"

#include <cmath>
#include <string>

#include "error_from.h"
#include "exported_xml.h"
#include "generic_models.h"
#include <Eigen/Geometry>
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::UnorderedElementsAre;

pugi::xml_node BaseLinkIn(const ExportedFile& file, pugi::xml_document* document) {
  Parse(file, document);
  return document->child("scenario").child("robot").child("base_link");
}

Eigen::Vector3d VectorIn(const pugi::xml_node& node, const char* attribute) {
  return NumbersIn(node.attribute(attribute).as_string());
}

// patrykcieslak/stonefish, Library/src/core/ScenarioParser.cpp, ParseSolid() and ParseRobot();
// docs/bodies.rst, docs/robots.rst, docs/materials.rst.
TEST(StonefishRobot, HasTheNamesOfTheParser) {
  pugi::xml_document document;
  const auto link = BaseLinkIn(
      StonefishRobot(ExportModelOf(GenericRov(), "rov.json"), GenericTarget()), &document);
  EXPECT_THAT(NamesBelow(document),
              UnorderedElementsAre("scenario",
                                   "materials",
                                   "looks",
                                   "robot",
                                   "base_link",
                                   "dimensions",
                                   "origin",
                                   "material",
                                   "look",
                                   "mass",
                                   "inertia",
                                   "cg",
                                   "hydrodynamics",
                                   "world_transform"));
  EXPECT_STREQ(link.attribute("type").as_string(), "box");
  EXPECT_STREQ(link.attribute("physics").as_string(), "submerged");
}

// Each face as SolidEntity.cpp (38579136) sums it: form drag where the flow comes to a face, skin
// friction along it.
TEST(StonefishRobot, DragsAsTheModelAtTheMatchedSpeed) {
  const CoupledModel model = GenericRov().model;
  ExportTarget target = GenericTarget();
  target.matched_speed = 0.8;
  pugi::xml_document document;
  const auto link =
      BaseLinkIn(StonefishRobot(ExportModelOf(GenericRov(), "rov.json"), target), &document);
  const Eigen::Vector3d box = VectorIn(link.child("dimensions"), "xyz");
  const Eigen::Vector3d viscous = VectorIn(link.child("hydrodynamics"), "viscous_drag");
  const Eigen::Vector3d quadratic = VectorIn(link.child("hydrodynamics"), "quadratic_drag");
  for (int i = 0; i < 3; ++i) {
    double form = 0.0, skin = 0.0;
    for (int face = 0; face < 6; ++face) {
      const int axis = face / 2;
      const double area = box.prod() / box[axis], v = target.matched_speed;
      if (axis != i) skin += v * area;
      if (axis == i && face % 2 == 0) form += v * v * v * area;
    }
    const double drag = 0.5 * 1000.0 * quadratic[i] * form + 1000.0 * viscous[i] * skin;
    EXPECT_NEAR(
        drag, 0.8 * model.linear_damping(i, i) + 0.64 * model.quadratic_damping(i, i), 1e-9);
  }
}

// 30 kg and 2 N of buoyancy: (30 + 2/9.81)/1000 m^3.
TEST(StonefishRobot, HasTheBodyAndTheVolumeOfTheVehicle) {
  pugi::xml_document document;
  const auto link = BaseLinkIn(
      StonefishRobot(ExportModelOf(GenericRov(), "rov.json"), GenericTarget()), &document);
  const Eigen::Vector3d box = VectorIn(link.child("dimensions"), "xyz");
  EXPECT_NEAR(box.prod(), 0.030203874, 1e-9);
  EXPECT_NEAR(box[0] / box[1], 0.7 / 0.5, 1e-12);
  EXPECT_EQ(link.child("mass").attribute("value").as_double(), 30.0);
  EXPECT_EQ(VectorIn(link.child("cg"), "xyz"), Eigen::Vector3d(0.03, -0.02, 0.04));
  const Eigen::Vector3d rpy = VectorIn(link.child("cg"), "rpy");
  const Eigen::Matrix3d axes = (Eigen::AngleAxisd(rpy[2], Eigen::Vector3d::UnitZ()) *
                                Eigen::AngleAxisd(rpy[1], Eigen::Vector3d::UnitY()) *
                                Eigen::AngleAxisd(rpy[0], Eigen::Vector3d::UnitX()))
                                   .toRotationMatrix();
  const Eigen::Vector3d moments = VectorIn(link.child("inertia"), "xyz");
  const Eigen::Matrix3d truth = *InertiaAboutCentreOfMass(GenericTarget().vehicle->body);
  EXPECT_LT((axes * moments.asDiagonal() * axes.transpose() - truth).norm(), 1e-12);
  EXPECT_LT(rpy.norm(), 0.3);  // the axes nearest to the body's
}

TEST(StonefishRobot, NamesWhatItCannotHold) {
  const ExportedFile file =
      StonefishRobot(ExportModelOf(GenericRov(), "rov.json"), GenericTarget());
  for (const char* said : {"It equals the quadratic damping at 0.5 m/s",
                           "That of the model is 10, 31 and 42 kg along x, y and z.",
                           "linear_damping.yaw of 0.8 kg m^2/s is left out",
                           "inertia.sway.yaw of 2.2 kg m is left out: added mass is made",
                           "expected `<water density=\"1000\"/>`"}) {
    EXPECT_THAT(file.remarks, Contains(HasSubstr(said)));
  }
}

// Stonefish takes no three of them where one is below 0:
// SolidEntity::SetHydrodynamicCoefficients().
TEST(StonefishRobot, FailsItsCheckOfADampingBelow0) {
  FittedCoupledModel fitted = GenericRov();
  SetValue(LinearDampingEntry(Dof::kSway, Dof::kSway), -1.0, &fitted.model);
  EXPECT_THAT(StonefishRobot(ExportModelOf(fitted, "rov.json"), GenericTarget()).problems,
              ElementsAre(HasSubstr("linear_damping.sway is -1 kg/s, expected at least 0")));
}

TEST(StonefishRobot, RefusesAVehicleWithoutSize) {
  ExportTarget target = GenericTarget();
  target.vehicle->size.reset();
  EXPECT_THAT(ErrorFrom([&] { StonefishRobot(ExportModelOf(GenericRov(), "rov.json"), target); }),
              HasSubstr("expected `size: [0.46, 0.58, 0.25]`"));
}

}  // namespace
}  // namespace fathom
