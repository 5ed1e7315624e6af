// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/exporting/gazebo.h"

#include "fathom/vehicle/coupled/entry_value.h"

#include <cmath>
#include <string>

#include "error_from.h"
#include "exported_xml.h"
#include "generic_models.h"
#include "written_out_rate.h"
#include <gmock/gmock.h>
#include <pugixml.hpp>

namespace fathom {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// What a physics engine takes for the inertia about the link's origin.
Matrix6 InertiaIn(const pugi::xml_node& inertial) {
  return BodyInertiaIn(inertial) + SymmetricOf(inertial.child("fluid_added_mass"), "", "xyzpqr");
}

// The wrench of the plugin at a velocity, by the law of its documentation: the force along each
// axis is the sum of xU u + xUabsU |u| u and their like.
Vector6 WrenchOf(const pugi::xml_node& plugin, const Vector6& nu) {
  const std::string forces = "xyzkmn", speeds = "UVWPQR";
  Vector6 wrench = Vector6::Zero();
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      const std::string name = {forces[static_cast<std::size_t>(i)],
                                speeds[static_cast<std::size_t>(j)]};
      const std::string quadratic = name + "abs" + name[1];
      wrench[i] += plugin.child(name.c_str()).text().as_double(0.0) * nu[j];
      wrench[i] += plugin.child(quadratic.c_str()).text().as_double(0.0) * std::abs(nu[j]) * nu[j];
    }
  }
  return wrench;
}

pugi::xml_node ModelIn(const ExportedFile& file, pugi::xml_document* document) {
  Parse(file, document);
  EXPECT_STREQ(document->child("sdf").attribute("version").as_string(), "1.10");
  return document->child("sdf").child("model");
}

// y and z point the other way: of velocities and forces both, and of turns about them.
Vector6 InZUp(const Vector6& v) { return {v[0], -v[1], -v[2], v[3], -v[4], -v[5]}; }

// Kinetic energy and the momentum's components do not depend on whose axes they are told in.
TEST(GazeboModel, HasTheInertiaOfTheModelInItsOwnAxes) {
  const FittedCoupledModel fitted = GenericRov();
  pugi::xml_document document;
  const auto model =
      ModelIn(GazeboModel(ExportModelOf(fitted, "rov.json"), GenericTarget()), &document);
  const Matrix6 inertia = InertiaIn(model.child("link").child("inertial"));
  for (const DrawnState& state : DrawnStates(fitted.model, 10, true)) {
    const Vector6 momentum = fitted.model.inertia * state.nu;
    EXPECT_LT((inertia * InZUp(state.nu) - InZUp(momentum)).norm(), 1e-12 * momentum.norm());
  }
}

TEST(GazeboModel, DampsAsTheModel) {
  const FittedCoupledModel fitted = GenericRov();
  pugi::xml_document document;
  const auto model =
      ModelIn(GazeboModel(ExportModelOf(fitted, "rov.json"), GenericTarget()), &document);
  const auto plugin = model.child("plugin");
  EXPECT_STREQ(plugin.attribute("name").as_string(), "gz::sim::systems::Hydrodynamics");
  EXPECT_STREQ(plugin.child("link_name").text().as_string(),
               model.child("link").attribute("name").as_string());
  for (const DrawnState& state : DrawnStates(fitted.model, 10, true)) {
    const Vector6 nu = state.nu;
    const Vector6 truth = -(fitted.model.linear_damping * nu +
                            fitted.model.quadratic_damping * nu.cwiseAbs().cwiseProduct(nu));
    EXPECT_LT((WrenchOf(plugin, InZUp(nu)) - InZUp(truth)).norm(), 1e-12 * truth.norm());
  }
}

TEST(GazeboModel, HasNegativeDampingsAndNoAddedMassInThePlugin) {
  pugi::xml_document document;
  const auto model =
      ModelIn(GazeboModel(ExportModelOf(GenericRov(), "rov.json"), GenericTarget()), &document);
  EXPECT_EQ(NumberOf(model.child("plugin"), "xU"), -5.0);
  EXPECT_EQ(NumberOf(model.child("plugin"), "xUabsU"), -30.0);
  EXPECT_EQ(NumberOf(model.child("plugin"), "nR"), -0.8);
  for (const auto& element : model.child("plugin").children()) {
    EXPECT_EQ(std::string(element.name()).find("Dot"), std::string::npos) << element.name();
  }
}

// Of DOFs that nobody modelled the body alone is known; of models of one DOF each the diagonal.
TEST(GazeboModel, HasNoAddedMassWhereTheModelTellsNone) {
  FittedModel surge = GenericOneDof(Dof::kSurge);
  surge.model.inertia = 41.0;
  FittedModel pitch = GenericOneDof(Dof::kPitch);
  pugi::xml_document document;
  const ExportedFile file =
      GazeboModel(ExportModelOf({surge, pitch}, {"surge.json", "pitch.json"}), GenericTarget());
  const auto added =
      ModelIn(file, &document).child("link").child("inertial").child("fluid_added_mass");
  Matrix6 truth = Matrix6::Zero();
  truth(0, 0) = 41.0 - 30.0;
  truth(4, 4) = pitch.model.inertia - 1.7;
  EXPECT_LT((SymmetricOf(added, "", "xyzpqr") - truth).norm(), 1e-12);
  EXPECT_THAT(file.remarks,
              Contains("Not modelled: sway, heave, roll and yaw. Their added mass and damping are "
                       "not known and stand as 0."));
  EXPECT_THAT(file.remarks, Contains(HasSubstr("no Coriolis forces, but Gazebo adds")));
}

// Each stands in the file as it does on stderr.
TEST(GazeboModel, NamesWhatItCannotHold) {
  const ExportedFile file = GazeboModel(ExportModelOf(GenericRov(), "rov.json"), GenericTarget());
  for (const std::string& remark : file.remarks) EXPECT_THAT(file.text, HasSubstr(remark));
  EXPECT_THAT(file.remarks, Contains(HasSubstr("offset.surge of 0.03 N is left out")));
  EXPECT_THAT(file.remarks, Contains(HasSubstr("thrust_gain.port of 0.8 is left out")));
  // (30 + 2/9.8)/1000.
  EXPECT_THAT(file.remarks, Contains(HasSubstr("a volume of 0.0302041 m^3")));
  // B = 296 N, W = 294 N, x_b = (294 x 0.03 - 0.15)/296, y_b = (-294 x 0.02 - 0.12)/296 and, of the
  // mean of 6 and 7 N m, z_b = (294 x 0.04 - 6.5)/296.
  EXPECT_THAT(file.remarks,
              Contains(HasSubstr("its centre at 0.02929, 0.02027, -0.01777 m (x fo")));
  EXPECT_THAT(file.remarks, Contains(HasSubstr("by 6.5 N m, instead of 6 N m in roll and 7 N m")));
}

// 30 kg in 1000 kg/m^3.
TEST(GazeboModel, SaysThatANetBuoyancyIsNotKnown) {
  const ExportedFile file = GazeboModel(ExportModelOf(GenericBoat(), "boat.json"), GenericTarget());
  EXPECT_THAT(file.remarks, Contains(HasSubstr("a volume of 0.03 m^3")));
  EXPECT_THAT(file.remarks,
              Contains("The net buoyancy is not known: the volume is that of a vehicle that "
                       "hovers."));
}

TEST(GazeboModel, NamesAnInertiaByADofThatIsNotModelled) {
  FittedCoupledModel fitted = GenericBoat();
  SetValue(InertiaEntry(Dof::kSway, Dof::kRoll), 1.25, &fitted.model);
  const ExportedFile file = GazeboModel(ExportModelOf(fitted, "boat.json"), GenericTarget());
  EXPECT_THAT(file.remarks,
              Contains("inertia.sway.roll of 1.25 kg m is left out: roll is not modelled."));
}

TEST(GazeboModel, RefusesAVehicleWhoseBodyIsNotKnown) {
  ExportTarget target = GenericTarget();
  target.vehicle->body.centre_of_mass.reset();
  EXPECT_THAT(ErrorFrom([&] { GazeboModel(ExportModelOf(GenericRov(), "rov.json"), target); }),
              HasSubstr("`rigid_body: {centre_of_mass: [0, 0, 0.02]}`"));
}

TEST(GazeboModel, FailsItsCheckWhereTheAddedMassWouldBeNegative) {
  FittedCoupledModel fitted = GenericRov();
  SetValue(InertiaEntry(Dof::kSurge, Dof::kSurge), 25.0, &fitted.model);
  const ExportedFile file = GazeboModel(ExportModelOf(fitted, "rov.json"), GenericTarget());
  EXPECT_EQ(file.text, "");
  EXPECT_THAT(file.problems,
              ElementsAre(HasSubstr("The inertia of surge is 25, below the 30 of the body")));
}

}  // namespace
}  // namespace fathom
