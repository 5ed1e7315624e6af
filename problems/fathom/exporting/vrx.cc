// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/exporting/vrx.h"

#include "fathom/exporting/format_features.h"
#include "fathom/exporting/split_inertia.h"
#include "fathom/exporting/xml_elements.h"

#include <array>
#include <cstddef>
#include <string>

#include <fmt/format.h>

namespace fathom {
namespace {

struct VrxNames {
  const char *added, *linear, *quadratic;
};

// In the order of Dof.
constexpr std::array<VrxNames, 6> kVrxNames = {{{"xDotU", "xU", "xUU"},
                                                {"yDotV", "yV", "yVV"},
                                                {"zDotW", "zW", "zWW"},
                                                {"kDotP", "kP", "kPP"},
                                                {"mDotQ", "mQ", "mQQ"},
                                                {"nDotR", "nR", "nRR"}}};

std::string VrxPlugin(const ExportModel& model, const Matrix6& added) {
  std::string text =
      "    <plugin filename=\"libSimpleHydrodynamics.so\" name=\"vrx::SimpleHydrodynamics\">\n" +
      Element(3, "link_name", "base_link");
  for (const Dof dof : kAllDofs) {
    text += Element(3,
                    kVrxNames[static_cast<std::size_t>(Index(dof))].added,
                    added(Index(dof), Index(dof)),
                    fmt::format("{}: M less the rigid body, above 0", Name(dof)));
  }
  for (const Dof dof : kAllDofs) {
    const VrxNames& names = kVrxNames[static_cast<std::size_t>(Index(dof))];
    text += EntryElement(3, names.linear, model, LinearDampingEntry(dof, dof), 1.0) +
            EntryElement(3, names.quadratic, model, QuadraticDampingEntry(dof, dof), 1.0);
  }
  return text + "    </plugin>\n";
}

}  // namespace

ExportedFile VrxModel(const ExportModel& model, const ExportTarget& target) {
  ExportedFile file;
  file.remarks = RemarksOn(ExportFormat::kVrx, model, target);
  const SplitInertia split = SplitInertiaOf(model, target, ExportFormat::kVrx);
  file.problems = split.problems;
  if (!file.problems.empty()) return file;
  file.text = XmlHead(model, target, file.remarks) +
              "     For VRX with Gazebo Garden or later. Body: x forward, y port, z up.\n"
              "     Added mass and dampings above 0: the other way round than Gazebo's own. -->\n"
              "<sdf version=\"1.9\">\n" +
              fmt::format("  <model name=\"{}\">\n", target.name) +
              "    <link name=\"base_link\">\n" + InertiaComment(model) +
              InertialElement(split.body) + "    </link>\n" + VrxPlugin(model, split.added_mass) +
              "  </model>\n"
              "</sdf>\n";
  return file;
}

}  // namespace fathom
