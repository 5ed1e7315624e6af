// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/exporting/uuv.h"

#include "fathom/vehicle/coupled/entry_value.h"
#include "fathom/vehicle/effects/catalogue.h"

#include <string>

#include "error_from.h"
#include "exported_xml.h"
#include "generic_models.h"
#include "written_out_rate.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

// From the plugin's own file, row by row or a diagonal.
Matrix6 MatrixIn(const pugi::xml_node& node, const char* name) {
  const Eigen::VectorXd numbers = NumbersIn(node.child(name).text().as_string());
  if (numbers.size() == 6) return numbers.asDiagonal();
  EXPECT_EQ(numbers.size(), 36) << name;
  return Eigen::Map<const Eigen::Matrix<double, 6, 6, Eigen::RowMajor>>(numbers.data());
}

pugi::xml_node LinkIn(const ExportedFile& file, pugi::xml_document* document) {
  Parse(file, document);
  return document->child("sdf").child("model").child("plugin").child("link");
}

// What HMFossen reads and BuoyantObject, and what holds them: uuvsimulator/uuv_simulator,
// uuv_gazebo_plugins/src/HydrodynamicModel.cc (bea0a1b7) and UnderwaterObjectPlugin.cc.
TEST(UuvModel, HasTheNamesOfThePlugin) {
  pugi::xml_document document;
  LinkIn(UuvModel(ExportModelOf(GenericRov(), "rov.json"), GenericTarget()), &document);
  EXPECT_THAT(NamesBelow(document.child("sdf").child("model").child("plugin")),
              ElementsAre("added_mass",
                          "box",
                          "center_of_buoyancy",
                          "flow_velocity_topic",
                          "fluid_density",
                          "height",
                          "hydrodynamic_model",
                          "length",
                          "linear_damping",
                          "link",
                          "neutrally_buoyant",
                          "quadratic_damping",
                          "type",
                          "volume",
                          "width"));
}

// The plugin's law, in x forward, y starboard, z down: D = -D_L - diag(D_Q |nu|) and
// tau = -M_A dnu/dt - D nu, HydrodynamicModel.cc.
TEST(UuvModel, HasTheInertiaAndDampingOfTheModel) {
  FittedCoupledModel fitted = GenericRov();
  SetValue(QuadraticDampingEntry(Dof::kSway, Dof::kRoll), 0.0, &fitted.model);
  pugi::xml_document document;
  const auto link = LinkIn(UuvModel(ExportModelOf(fitted, "rov.json"), GenericTarget()), &document);
  const auto water = link.child("hydrodynamic_model");
  const Matrix6 added = MatrixIn(water, "added_mass");
  const Matrix6 body = *RigidInertia(GenericTarget().vehicle->body);
  EXPECT_LT((added + body - fitted.model.inertia).norm(), 1e-12 * fitted.model.inertia.norm());
  const Matrix6 linear = MatrixIn(water, "linear_damping");
  const Matrix6 quadratic = MatrixIn(water, "quadratic_damping");
  for (const DrawnState& state : DrawnStates(fitted.model, 10, true)) {
    const Vector6 nu = state.nu;
    const Vector6 damping = -(linear * nu) - quadratic * nu.cwiseAbs().cwiseProduct(nu);
    const Vector6 truth = fitted.model.linear_damping * nu +
                          fitted.model.quadratic_damping * nu.cwiseAbs().cwiseProduct(nu);
    EXPECT_LT((damping - truth).norm(), 1e-12 * truth.norm());
  }
}

// The body in Gazebo's axes: y and z point the other way.
TEST(UuvModel, HasTheBodyInAxesOfGazebo) {
  pugi::xml_document document;
  LinkIn(UuvModel(ExportModelOf(GenericRov(), "rov.json"), GenericTarget()), &document);
  const Matrix6 inertia =
      BodyInertiaIn(document.child("sdf").child("model").child("link").child("inertial"));
  const Vector6 turn{1.0, -1.0, -1.0, 1.0, -1.0, -1.0};
  const Matrix6 truth =
      turn.asDiagonal() * *RigidInertia(GenericTarget().vehicle->body) * turn.asDiagonal();
  EXPECT_LT((inertia - truth).norm(), 1e-12 * truth.norm());
}

TEST(UuvModel, NamesWhatItCannotHold) {
  FittedModel surge = GenericOneDof(Dof::kSurge);
  surge.model.inertia = 41.0;
  const Effect* lag = FindEffect("thruster_lag");
  surge.effects = {{lag, {}, {0.5}}};
  const ExportedFile of_lag = UuvModel(ExportModelOf({surge}, {"surge.json"}), GenericTarget());
  EXPECT_THAT(of_lag.remarks,
              Contains(HasSubstr("thruster_lag of surge is left out (time_constant 0.5 s): "
                                 "<dynamics> of type FirstOrder")));
  const ExportedFile file = UuvModel(ExportModelOf(GenericRov(), "rov.json"), GenericTarget());
  EXPECT_THAT(file.remarks,
              Contains("quadratic_damping.sway.roll of 0.2 kg m is left out: the plugin takes the "
                       "diagonal alone."));
  EXPECT_THAT(file.remarks, Contains(HasSubstr("offset.yaw of -0.18 N m is left out")));
  EXPECT_THAT(file.remarks, Contains(HasSubstr("at the centre of mass")));
  EXPECT_THAT(file.text, HasSubstr("linear_damping.sway.yaw 0.7"));
}

TEST(UuvModel, RefusesAVehicleWhoseBodyIsNotKnown) {
  ExportTarget target = GenericTarget();
  target.vehicle->body.mass.reset();
  EXPECT_THAT(ErrorFrom([&] { UuvModel(ExportModelOf(GenericRov(), "rov.json"), target); }),
              HasSubstr("--format=uuv wants the body and its added mass apart: expected `mass: "));
}

}  // namespace
}  // namespace fathom
