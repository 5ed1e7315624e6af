// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/exporting/stonefish.h"

#include "fathom/exporting/comment_text.h"
#include "fathom/exporting/format_features.h"
#include "fathom/exporting/hydrostatics.h"
#include "fathom/exporting/split_inertia.h"
#include "fathom/exporting/xml_elements.h"
#include "fathom/solve/decompositions.h"
#include "fathom/vehicle/coupled/entry_name.h"

#include <array>
#include <cmath>
#include <string>

#include <Eigen/LU>
#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kGravityOfStonefish = 9.81;  // [m/s^2]

struct Coefficients {
  Eigen::Vector3d viscous = Eigen::Vector3d::Zero();    // Cf [m/s]
  Eigen::Vector3d quadratic = Eigen::Vector3d::Zero();  // Cd
};

Coefficients CoefficientsOf(const CoupledModel& model, const Eigen::Vector3d& box, double speed) {
  Coefficients coefficients;
  for (int i = 0; i < 3; ++i) {
    const double a = box[(i + 1) % 3], b = box[(i + 2) % 3];
    coefficients.viscous[i] = model.linear_damping(i, i) / (kWaterDensity * 2.0 * box[i] * (a + b));
    coefficients.quadratic[i] =
        model.quadratic_damping(i, i) / (0.5 * kWaterDensity * a * b * speed);
  }
  return coefficients;
}

// Principal moments, each by the axis that it is nearest to, and the angles of their axes: yaw,
// pitch, roll in this order, as Stonefish reads rpy.
struct PrincipalInertia {
  Eigen::Vector3d moments, roll_pitch_yaw;
};

PrincipalInertia PrincipalInertiaOf(const Eigen::Matrix3d& tensor) {
  const SymmetricEigen eigen = EigenOf(tensor);
  const Eigen::Matrix3d vectors = eigen.vectors;
  // The order and senses of the axes in which the turn is smallest.
  constexpr std::array<std::array<int, 3>, 6> kOrders = {
      {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
  PrincipalInertia principal;
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  double largest = -1.0;
  for (const auto& order : kOrders) {
    Eigen::Matrix3d candidate;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d v = vectors.col(order[i]);
      candidate.col(i) = v[i] < 0.0 ? Eigen::Vector3d(-v) : v;
    }
    if (candidate.determinant() < 0.0 || candidate.trace() <= largest) continue;
    largest = candidate.trace();
    axes = candidate;
    for (int i = 0; i < 3; ++i) principal.moments[i] = eigen.values[order[i]];
  }
  principal.roll_pitch_yaw = {std::atan2(axes(2, 1), axes(2, 2)),
                              std::asin(-axes(2, 0)),
                              std::atan2(axes(1, 0), axes(0, 0))};
  principal.roll_pitch_yaw.array() += 0.0;  // 0 for -0
  return principal;
}

std::string Place(const Eigen::Vector3d& xyz, const Eigen::Vector3d& rpy) {
  return fmt::format("xyz=\"{}\" rpy=\"{}\"", NumbersText(xyz), NumbersText(rpy));
}

void AddNegativeDampings(const ExportModel& model, std::vector<std::string>* problems) {
  for (const ExportNumber& number : model.numbers) {
    const bool is_damping = number.entry.kind == FreeEntry::Kind::kLinearDamping ||
                            number.entry.kind == FreeEntry::Kind::kQuadraticDamping;
    if (!is_damping || number.entry.row != number.entry.column || IsAngular(number.entry.row) ||
        number.value >= 0.0)
      continue;
    problems->push_back(
        fmt::format("{} is {:.4g} {}, expected at least 0: Stonefish would ignore the drag of all "
                    "three axes.",
                    NameOf(number.entry),
                    number.value,
                    number.unit));
  }
}

std::string BaseLink(const ExportModel& model,
                     const ExportTarget& target,
                     const RigidBody& body,
                     const Hydrostatics& water) {
  const Eigen::Vector3d none = Eigen::Vector3d::Zero();
  const Eigen::Vector3d& size = *target.vehicle->size;
  const Eigen::Vector3d box = std::cbrt(water.volume / size.prod()) * size;
  const Coefficients drag = CoefficientsOf(model.model, box, target.matched_speed);
  const PrincipalInertia inertia = PrincipalInertiaOf(*InertiaAboutCentreOfMass(body));
  return fmt::format(
      "    <base_link name=\"base_link\" type=\"box\" physics=\"submerged\" buoyant=\"true\">\n"
      "{0}{1}"
      "      <!-- {2} m^3 of water, in the proportions of the vehicle's size [m] -->\n"
      "      <dimensions xyz=\"{3}\"/>\n"
      "      <origin {4}/>  <!-- centre of buoyancy [m] -->\n"
      "      <material name=\"{5}\"/>\n"
      "      <look name=\"{5}\"/>\n"
      "      <mass value=\"{6}\"/>  <!-- dry, kg, vehicle file -->\n"
      "      <inertia xyz=\"{7}\"/>  <!-- principal, about the centre of mass [kg m^2] -->\n"
      "      <cg {8}/>  <!-- centre of mass [m], principal axes [rad] -->\n"
      "{9}{10}"
      "      <hydrodynamics viscous_drag=\"{11}\" quadratic_drag=\"{12}\"/>\n"
      "    </base_link>\n",
      InertiaComment(model),
      NumbersComment(
          3,
          model,
          {ExportFeature::kNetBuoyancy, ExportFeature::kRightingMoment, ExportFeature::kTrim},
          "size and place of the box are made from the mass and"),
      LiteralOf(water.volume),
      NumbersText(box),
      Place(water.centre_of_buoyancy, none),
      target.name,
      LiteralOf(*body.mass),
      NumbersText(inertia.moments),
      Place(*body.centre_of_mass, inertia.roll_pitch_yaw),
      NumbersComment(3, model, {ExportFeature::kLinearDamping}, "viscous_drag [m/s] is of"),
      NumbersComment(3,
                     model,
                     {ExportFeature::kQuadraticDamping},
                     fmt::format("quadratic_drag is, at {} m/s, of", target.matched_speed)),
      NumbersText(drag.viscous),
      NumbersText(drag.quadratic));
}

}  // namespace

ExportedFile StonefishRobot(const ExportModel& model, const ExportTarget& target) {
  ExportedFile file;
  file.remarks = RemarksOn(ExportFormat::kStonefish, model, target);
  const SplitInertia split =
      SplitInertiaOf(model, target, ExportFormat::kStonefish, /*needs_size=*/true);
  const Hydrostatics water = HydrostaticsOf(model, split.body, kGravityOfStonefish);
  AddTo(split.problems, &file.problems);
  AddTo(water.problems, &file.problems);
  AddNegativeDampings(model, &file.problems);
  if (!file.problems.empty()) return file;
  AddTo(water.remarks, &file.remarks);
  const Eigen::Vector3d added = split.added_mass.diagonal().head<3>();
  file.remarks.push_back(
      fmt::format("Stonefish's form drag grows with the third power of the speed. It equals the "
                  "quadratic damping at {} m/s: below it is too small, above too large.",
                  target.matched_speed));
  file.remarks.push_back(
      fmt::format("Stonefish makes the added mass from the shape, the same along all axes. That of "
                  "the model is {:.4g}, {:.4g} and {:.4g} kg along x, y and z.",
                  added[0],
                  added[1],
                  added[2]));
  file.remarks.push_back(
      fmt::format("The volume is for {0} kg/m^3: expected `<water density=\"{0}\"/>` in <ocean>.",
                  kWaterDensity));
  file.text = XmlHead(model, target, file.remarks) +
              fmt::format(
                  "     x forward, y starboard, z down. -->\n"
                  "<scenario>\n"
                  "  <materials>\n"
                  "    <material name=\"{0}\" density=\"1000.0\" restitution=\"0.5\"/>\n"
                  "  </materials>\n"
                  "  <looks>\n"
                  "    <look name=\"{0}\" rgb=\"0.9 0.8 0.1\" roughness=\"0.5\"/>\n"
                  "  </looks>\n"
                  "  <robot name=\"{0}\" fixed=\"false\" self_collisions=\"false\">\n"
                  "{1}"
                  "    <world_transform xyz=\"0.0 0.0 2.0\" rpy=\"0.0 0.0 0.0\"/>\n"
                  "  </robot>\n"
                  "</scenario>\n",
                  target.name,
                  BaseLink(model, target, split.body, water));
  return file;
}

}  // namespace fathom
