// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/exporting/gazebo.h"

#include "fathom/base/input_error.h"
#include "fathom/exporting/comment_text.h"
#include "fathom/exporting/gazebo_remarks.h"
#include "fathom/vehicle/coupled/rigid_body.h"

#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Cholesky>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

constexpr std::string_view kSdfAxes = "xyzpqr";          // of <fluid_added_mass>
constexpr std::string_view kForceLetters = "xyzkmn";     // of the plugin
constexpr std::string_view kVelocityLetters = "UVWPQR";  // of the plugin

// 1 of x and roll, -1 of the axes that point the other way.
double TurnOf(int axis) { return axis == 0 || axis == 3 ? 1.0 : -1.0; }

// 0 for -0.
double Turned(double value, double sign) { return value == 0.0 ? 0.0 : sign * value; }

Eigen::Vector3d TurnedVector(const Eigen::Vector3d& v) {
  return {v[0], Turned(v[1], -1.0), Turned(v[2], -1.0)};
}

RigidBody RequireRigidBody(const ExportTarget& target) {
  const RigidBody body = target.vehicle ? target.vehicle->body : RigidBody();
  std::vector<std::string> missing;
  if (!body.mass) missing.push_back("mass: 13.5");
  std::vector<std::string> keys;
  if (!body.inertia_tensor) {
    keys.push_back("inertia_tensor: [[0.4, 0, 0], [0, 0.6, 0], [0, 0, 0.8]]");
  }
  if (!body.centre_of_mass) keys.push_back("centre_of_mass: [0, 0, 0.02]");
  if (!keys.empty()) {
    missing.push_back(fmt::format("rigid_body: {{{}}}", fmt::join(keys, ", ")));
  }
  if (missing.empty()) return body;
  throw InputError(fmt::format(
      "--vehicle: {}. Gazebo wants the body and its added mass apart: expected `{}` in the vehicle "
      "file, with your own numbers (about the body's origin; docs/file_formats.md).",
      target.vehicle ? "does not tell all of the body without its water" : "is missing",
      fmt::join(missing, "` and `")));
}

// M - M_rigid where the model tells M.
Matrix6 AddedMassOf(const ExportModel& model, const Matrix6& rigid) {
  Matrix6 added = Matrix6::Zero();
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      const bool is_known = IsModelled(model, kAllDofs[i]) && IsModelled(model, kAllDofs[j]) &&
                            (i == j || !model.is_joined);
      if (is_known) added(i, j) = model.model.inertia(i, j) - rigid(i, j);
    }
  }
  return added;
}

std::vector<std::string> ProblemsOf(const ExportModel& model,
                                    const Matrix6& rigid,
                                    const Matrix6& added) {
  std::vector<std::string> problems;
  for (const Dof dof : model.model.dofs) {
    const auto i = Index(dof);
    if (added(i, i) >= 0.0) continue;
    problems.push_back(
        fmt::format("The inertia of {} is {:.4g}, below the {:.4g} of the body without its water: "
                    "the added mass would be below 0. Weigh the vehicle, or doubt the thrust.",
                    Name(dof),
                    model.model.inertia(i, i),
                    rigid(i, i)));
  }
  if (problems.empty() && Eigen::LLT<Matrix6>(rigid + added).info() != Eigen::Success) {
    problems.push_back(
        "The body with its added mass has an inertia that is not positive definite: the rigid body "
        "of the DOFs that are not modelled contradicts the model.");
  }
  return problems;
}

// "<mass>13.5</mass>", indented.
std::string Element(int depth,
                    std::string_view name,
                    double value,
                    const std::string& comment = "") {
  return fmt::format("{:{}}<{}>{}</{}>{}\n",
                     "",
                     2 * depth,
                     name,
                     LiteralOf(value),
                     name,
                     comment.empty() ? "" : "  <!-- " + comment + " -->");
}

std::string InertialElement(const RigidBody& body, const Matrix6& added) {
  const Eigen::Vector3d centre = TurnedVector(*body.centre_of_mass);
  const Eigen::Matrix3d about_centre = *InertiaAboutCentreOfMass(body);
  std::string text = fmt::format(
      "      <inertial>\n"
      "        <pose>{} {} {} 0 0 0</pose>  <!-- centre of mass, x forward, y port, z up [m] -->\n"
      "{}"
      "        <inertia>  <!-- about the centre of mass [kg m^2] -->\n",
      LiteralOf(centre[0]),
      LiteralOf(centre[1]),
      LiteralOf(centre[2]),
      Element(4, "mass", *body.mass, "dry, kg, vehicle file"));
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) {
      text += Element(5,
                      fmt::format("i{}{}", "xyz"[i], "xyz"[j]),
                      Turned(about_centre(i, j), TurnOf(i) * TurnOf(j)));
    }
  }
  text +=
      "        </inertia>\n"
      "        <fluid_added_mass>  <!-- M less the rigid body, about the link's origin -->\n";
  const Matrix6 turned = InAxesZUp(added);
  for (int i = 0; i < 6; ++i) {
    for (int j = i; j < 6; ++j) {
      text += Element(5, fmt::format("{}{}", kSdfAxes[i], kSdfAxes[j]), turned(i, j));
    }
  }
  return text +
         "        </fluid_added_mass>\n"
         "      </inertial>\n";
}

// The identified inertias, which stand in no element of their own.
std::string InertiaComments(const ExportModel& model) {
  std::string text =
      "      <!-- M of the model, about the body's origin, x forward, y starboard, z down:\n";
  for (const ExportNumber& number : model.numbers) {
    if (number.entry.kind != FreeEntry::Kind::kInertia) continue;
    text += fmt::format(
        "           {} {} {}\n", NameOf(number.entry), LiteralOf(number.value), CommentOn(number));
  }
  return text + "      -->\n";
}

// "xU", "xVabsV".
std::string PluginName(const FreeEntry& entry) {
  const auto i = static_cast<std::size_t>(Index(entry.row));
  const auto j = static_cast<std::size_t>(Index(entry.column));
  std::string name = {kForceLetters[i], kVelocityLetters[j]};
  if (entry.kind == FreeEntry::Kind::kQuadraticDamping) {
    name += std::string("abs") + kVelocityLetters[j];
  }
  return name;
}

std::string DampingElement(const ExportModel& model, const FreeEntry& entry) {
  const double turn = TurnOf(Index(entry.row)) * TurnOf(Index(entry.column));
  for (const ExportNumber& number : model.numbers) {
    if (!(number.entry == entry)) continue;
    return Element(3,
                   PluginName(entry),
                   Turned(number.value, -turn),
                   NameOf(entry) + ", " + CommentOn(number));
  }
  // On the diagonal the plugin of some versions has a default other than 0.
  return entry.row == entry.column ? Element(3, PluginName(entry), 0.0) : "";
}

std::string PluginElement(const ExportModel& model) {
  std::string text =
      "    <plugin filename=\"gz-sim-hydrodynamics-system\" "
      "name=\"gz::sim::systems::Hydrodynamics\">\n"
      "      <link_name>base_link</link_name>\n";
  for (const auto& entry_of : {LinearDampingEntry, QuadraticDampingEntry}) {
    for (const Dof row : kAllDofs) {
      for (const Dof column : kAllDofs) text += DampingElement(model, entry_of(row, column));
    }
  }
  return text + "    </plugin>\n";
}

}  // namespace

Matrix6 InAxesZUp(const Matrix6& matrix) {
  Matrix6 turned;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) turned(i, j) = Turned(matrix(i, j), TurnOf(i) * TurnOf(j));
  }
  return turned;
}

ExportedFile GazeboModel(const ExportModel& model, const ExportTarget& target) {
  const RigidBody body = RequireRigidBody(target);
  if (model.force_unit != "N") {
    throw InputError(
        fmt::format("--model: takes commands in {}, so that its inertia is not in kg. "
                    "Expected newtons for Gazebo.",
                    model.force_unit));
  }
  const Matrix6 rigid = *RigidInertia(body);
  const Matrix6 added = AddedMassOf(model, rigid);
  ExportedFile file;
  file.problems = ProblemsOf(model, rigid, added);
  if (!file.problems.empty()) return file;
  file.remarks = GazeboRemarks(model, body);
  file.text = fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<!-- {}\n"
      "     For Gazebo Garden or later, with a physics engine that takes fluid_added_mass (DART).\n"
      "     Body: x forward, y port, z up. -->\n"
      "<sdf version=\"1.10\">\n"
      "  <model name=\"{}\">\n"
      "    <link name=\"base_link\">\n"
      "{}{}"
      "    </link>\n"
      "{}"
      "  </model>\n"
      "</sdf>\n",
      fmt::join(HeadLines(model, target, file.remarks), "\n     "),
      target.name,
      InertiaComments(model),
      InertialElement(body, added),
      PluginElement(model));
  return file;
}

}  // namespace fathom
