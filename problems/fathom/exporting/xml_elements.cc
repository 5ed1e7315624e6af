// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/exporting/xml_elements.h"

#include "fathom/exporting/comment_text.h"
#include "fathom/exporting/split_inertia.h"
#include "fathom/vehicle/coupled/entry_name.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {

std::string XmlHead(const ExportModel& model,
                    const ExportTarget& target,
                    const std::vector<std::string>& remarks) {
  return fmt::format("<?xml version=\"1.0\"?>\n<!-- {}\n",
                     fmt::join(HeadLines(model, target, remarks), "\n     "));
}

std::string Element(int depth,
                    std::string_view name,
                    std::string_view text,
                    const std::string& comment) {
  return fmt::format("{:{}}<{}>{}</{}>{}\n",
                     "",
                     2 * depth,
                     name,
                     text,
                     name,
                     comment.empty() ? "" : "  <!-- " + comment + " -->");
}

std::string Element(int depth, std::string_view name, double value, const std::string& comment) {
  return Element(depth, name, std::string_view(LiteralOf(value)), comment);
}

std::string NumbersText(const Eigen::VectorXd& numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : " ") + LiteralOf(number);
  return text;
}

std::string NumbersComment(int depth,
                           const ExportModel& model,
                           std::initializer_list<ExportFeature> features,
                           std::string_view title) {
  std::string lines;
  for (const ExportNumber& number : model.numbers) {
    const ExportFeature feature = FeatureOf(number.entry);
    if (std::find(features.begin(), features.end(), feature) == features.end()) continue;
    lines += fmt::format("{:{}}{} {} {}\n",
                         "",
                         2 * depth + 5,
                         NameOf(number.entry),
                         LiteralOf(number.value),
                         CommentOn(number));
  }
  if (lines.empty()) return "";
  return fmt::format("{0:{1}}<!-- {2}:\n{3}{0:{1}}-->\n", "", 2 * depth, title, lines);
}

std::string InertiaComment(const ExportModel& model) {
  return NumbersComment(3,
                        model,
                        {ExportFeature::kInertia, ExportFeature::kInertiaCouplings},
                        "M of the model, about the body's origin, x forward, y starboard, z down");
}

std::string InertialElement(const RigidBody& body, const std::string& inside) {
  const Eigen::Vector3d centre = InAxesZUp(*body.centre_of_mass);
  Matrix6 about_centre = Matrix6::Zero();
  about_centre.bottomRightCorner<3, 3>() = *InertiaAboutCentreOfMass(body);
  about_centre = InAxesZUp(about_centre);
  std::string text = "      <inertial>\n" +
                     Element(4,
                             "pose",
                             NumbersText(centre) + " 0 0 0",
                             "centre of mass, x forward, y port, z up [m]") +
                     Element(4, "mass", *body.mass, "dry, kg, vehicle file") +
                     "        <inertia>  <!-- about the centre of mass [kg m^2] -->\n";
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) {
      text += Element(5, fmt::format("i{}{}", "xyz"[i], "xyz"[j]), about_centre(3 + i, 3 + j));
    }
  }
  return text + "        </inertia>\n" + inside + "      </inertial>\n";
}

std::string EntryElement(int depth,
                         std::string_view name,
                         const ExportModel& model,
                         const FreeEntry& entry,
                         double factor) {
  for (const ExportNumber& number : model.numbers) {
    if (!(number.entry == entry)) continue;
    const double value = number.value == 0.0 ? 0.0 : factor * number.value;
    return Element(depth, name, value, NameOf(entry) + ", " + CommentOn(number));
  }
  return entry.row == entry.column ? Element(depth, name, 0.0) : "";
}

}  // namespace fathom
