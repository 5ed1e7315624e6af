// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/exporting/export_model.h"
#include "fathom/exporting/export_target.h"
#include "fathom/exporting/format_features.h"
#include "fathom/vehicle/coupled/rigid_body.h"

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// Parts of XML files, each line indented by two spaces a level.

// What heads the file, up to the last line of its comment.
std::string XmlHead(const ExportModel& model,
                    const ExportTarget& target,
                    const std::vector<std::string>& remarks);

// "<mass>13.5</mass>", with a comment behind it.
std::string Element(int depth,
                    std::string_view name,
                    std::string_view text,
                    const std::string& comment = "");
std::string Element(int depth,
                    std::string_view name,
                    double value,
                    const std::string& comment = "");

// "0.1 0.0 -0.2".
std::string NumbersText(const Eigen::VectorXd& numbers);

// A comment with a line for each number of these features, as it was identified: name, value, unit,
// interval, log. `title` heads it. Empty where there is none.
std::string NumbersComment(int depth,
                           const ExportModel& model,
                           std::initializer_list<ExportFeature> features,
                           std::string_view title);

// That of the inertias, which stand in no element of their own, in a link.
std::string InertiaComment(const ExportModel& model);

// Gazebo's <inertial> of the body alone, with `inside` as its last element: x forward, y port, z
// up. `body`: all of it is known.
std::string InertialElement(const RigidBody& body, const std::string& inside = "");

// A plugin's own element for an entry, its value times `factor`. Where the model has no such entry
// an element on the diagonal is 0, because plugins have defaults other than 0; others are empty.
std::string EntryElement(int depth,
                         std::string_view name,
                         const ExportModel& model,
                         const FreeEntry& entry,
                         double factor);

}  // namespace fathom
