// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/exporting/gazebo.h"

#include "fathom/exporting/comment_text.h"
#include "fathom/exporting/format_features.h"
#include "fathom/exporting/hydrostatics.h"
#include "fathom/exporting/split_inertia.h"
#include "fathom/exporting/xml_elements.h"

#include <cstddef>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

constexpr double kGravityOfGazebo = 9.8;                 // [m/s^2], of its worlds
constexpr std::string_view kSdfAxes = "xyzpqr";          // of <fluid_added_mass>
constexpr std::string_view kForceLetters = "xyzkmn";     // of the plugin
constexpr std::string_view kVelocityLetters = "UVWPQR";  // of the plugin

std::string AddedMassElement(const Matrix6& added) {
  std::string text =
      "        <fluid_added_mass>  <!-- M less the rigid body, about the link's origin -->\n";
  const Matrix6 turned = InAxesZUp(added);
  for (int i = 0; i < 6; ++i) {
    for (int j = i; j < 6; ++j) {
      text += Element(5, fmt::format("{}{}", kSdfAxes[i], kSdfAxes[j]), turned(i, j));
    }
  }
  return text + "        </fluid_added_mass>\n";
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

std::string PluginElement(const ExportModel& model) {
  std::string text =
      "    <plugin filename=\"gz-sim-hydrodynamics-system\" "
      "name=\"gz::sim::systems::Hydrodynamics\">\n" +
      Element(3, "link_name", "base_link");
  const Matrix6 turn = InAxesZUp(Matrix6(Matrix6::Ones()));
  for (const auto& entry_of : {LinearDampingEntry, QuadraticDampingEntry}) {
    for (const Dof row : kAllDofs) {
      for (const Dof column : kAllDofs) {
        const FreeEntry entry = entry_of(row, column);
        text += EntryElement(3, PluginName(entry), model, entry, -turn(Index(row), Index(column)));
      }
    }
  }
  return text + "    </plugin>\n";
}

// Gazebo makes buoyancy from collisions, which are not ours to write.
std::string CollisionRemark(const Hydrostatics& water) {
  return fmt::format(
      "Weight and buoyancy come from Gazebo's gravity and gz::sim::systems::Buoyancy, which needs "
      "a collision. Give it a volume of {:.6g} m^3 (at {} kg/m^3 and {} m/s^2), with its centre at "
      "{:.4g} m (x forward, y port, z up): that makes the net buoyancy of {:.4g} N, the righting "
      "moments and their trim.",
      water.volume,
      kWaterDensity,
      kGravityOfGazebo,
      fmt::join(InAxesZUp(water.centre_of_buoyancy), ", "),
      water.buoyancy - water.weight);
}

}  // namespace

ExportedFile GazeboModel(const ExportModel& model, const ExportTarget& target) {
  ExportedFile file;
  file.remarks = RemarksOn(ExportFormat::kGazebo, model, target);
  const SplitInertia split = SplitInertiaOf(model, target, ExportFormat::kGazebo);
  const Hydrostatics water = HydrostaticsOf(model, split.body, kGravityOfGazebo);
  AddTo(split.problems, &file.problems);
  AddTo(water.problems, &file.problems);
  if (!file.problems.empty()) return file;
  file.remarks.push_back(CollisionRemark(water));
  AddTo(water.remarks, &file.remarks);
  file.text = fmt::format(
      "{}"
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
      XmlHead(model, target, file.remarks),
      target.name,
      InertiaComment(model),
      InertialElement(split.body, AddedMassElement(split.added_mass)),
      PluginElement(model));
  return file;
}

}  // namespace fathom
