// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/exporting/uuv.h"

#include "fathom/exporting/comment_text.h"
#include "fathom/exporting/format_features.h"
#include "fathom/exporting/hydrostatics.h"
#include "fathom/exporting/split_inertia.h"
#include "fathom/exporting/xml_elements.h"

#include <string>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kGravityOfUuv = 9.8;  // [m/s^2], of Gazebo classic's worlds

// Row by row, 0 for -0.
std::string MatrixText(const Matrix6& matrix, double factor) {
  const Eigen::Matrix<double, 6, 6, Eigen::RowMajor> rows = matrix;
  Eigen::VectorXd numbers = factor * Eigen::Map<const Eigen::VectorXd>(rows.data(), 36);
  numbers.array() += 0.0;
  return NumbersText(numbers);
}

// How high the vehicle is, for when it surfaces. The plugin's width is along x.
std::string BoxElement(const ExportTarget& target) {
  if (!target.vehicle->size) return "";
  const Eigen::Vector3d& size = *target.vehicle->size;
  return "        <box>\n" + Element(5, "width", size[0], "along x [m]") +
         Element(5, "length", size[1], "along y [m]") + Element(5, "height", size[2]) +
         "        </box>\n";
}

std::string HydrodynamicElements(const ExportModel& model, const Matrix6& added) {
  return "        <hydrodynamic_model>\n" + Element(5, "type", "fossen") +
         Element(5,
                 "added_mass",
                 MatrixText(added, 1.0),
                 "M less the rigid body, x forward, y starboard, z down") +
         NumbersComment(5,
                        model,
                        {ExportFeature::kLinearDamping,
                         ExportFeature::kQuadraticDamping,
                         ExportFeature::kDampingOfTurns,
                         ExportFeature::kLinearCouplings},
                        "dampings of the model, here below 0") +
         Element(5, "linear_damping", MatrixText(model.model.linear_damping, -1.0)) +
         Element(5,
                 "quadratic_damping",
                 NumbersText(
                     Eigen::VectorXd((-model.model.quadratic_damping.diagonal()).array() + 0.0))) +
         "        </hydrodynamic_model>\n";
}

std::string WaterComment(const ExportModel& model) {
  return NumbersComment(
      4,
      model,
      {ExportFeature::kNetBuoyancy, ExportFeature::kRightingMoment, ExportFeature::kTrim},
      "the volume and its centre are made from the mass and");
}

}  // namespace

ExportedFile UuvModel(const ExportModel& model, const ExportTarget& target) {
  ExportedFile file;
  file.remarks = RemarksOn(ExportFormat::kUuv, model, target);
  const SplitInertia split = SplitInertiaOf(model, target, ExportFormat::kUuv);
  const Hydrostatics water = HydrostaticsOf(model, split.body, kGravityOfUuv);
  AddTo(split.problems, &file.problems);
  AddTo(water.problems, &file.problems);
  if (!file.problems.empty()) return file;
  AddTo(water.remarks, &file.remarks);
  file.remarks.push_back(
      fmt::format("The volume is for {} kg/m^3 and a world with a gravity of {} m/s^2.",
                  kWaterDensity,
                  kGravityOfUuv));
  if (!split.body.centre_of_mass->isZero(0.0)) {
    file.remarks.push_back(
        "The plugin applies the forces of the water at the centre of mass, the model has them at "
        "the body's origin: they differ by the moment between the two.");
  }
  file.text = XmlHead(model, target, file.remarks) +
              "     For uuv_simulator and Plankton. Link: x forward, y port, z up; the plugin's\n"
              "     matrices: x forward, y starboard, z down. -->\n"
              "<sdf version=\"1.6\">\n" +
              fmt::format("  <model name=\"{}\">\n", target.name) +
              "    <link name=\"base_link\">\n" + InertiaComment(model) +
              InertialElement(split.body) +
              "    </link>\n"
              "    <plugin name=\"uuv_plugin\" "
              "filename=\"libuuv_underwater_object_ros_plugin.so\">\n" +
              Element(3, "fluid_density", kWaterDensity) +
              Element(3, "flow_velocity_topic", "hydrodynamics/current_velocity") +
              "      <link name=\"base_link\">\n" + Element(4, "neutrally_buoyant", "0") +
              WaterComment(model) + Element(4, "volume", water.volume, "m^3") +
              Element(4,
                      "center_of_buoyancy",
                      NumbersText(InAxesZUp(water.centre_of_buoyancy)),
                      "x forward, y port, z up [m]") +
              BoxElement(target) + HydrodynamicElements(model, split.added_mass) +
              "      </link>\n"
              "    </plugin>\n"
              "  </model>\n"
              "</sdf>\n";
  return file;
}

}  // namespace fathom
