// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/exporting/export_target.h"
#include "fathom/vehicle/coupled/six_vector.h"

#include <set>
#include <string>

#include <pugixml.hpp>

namespace fathom {

// Expects a file without problems that is XML and holds each of its remarks.
void Parse(const ExportedFile& file, pugi::xml_document* document);

// Of an element that has to be there.
double NumberOf(const pugi::xml_node& parent, const std::string& name);
Eigen::VectorXd NumbersIn(const std::string& text);

// Symmetric, of elements named by two letters.
Eigen::MatrixXd SymmetricOf(const pugi::xml_node& parent,
                            const std::string& prefix,
                            const std::string& letters);

// The inertia of the body alone about the link's origin, from the elements as SDF defines them:
// sdformat.org, <inertial>.
Matrix6 BodyInertiaIn(const pugi::xml_node& inertial);

// The names of all elements below.
std::set<std::string> NamesBelow(const pugi::xml_node& node);

}  // namespace fathom
