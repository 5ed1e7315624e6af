// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "exported_xml.h"

#include "fathom/vehicle/coupled/coriolis.h"

#include <cmath>
#include <sstream>
#include <vector>

#include <gmock/gmock.h>

namespace fathom {

void Parse(const ExportedFile& file, pugi::xml_document* document) {
  EXPECT_THAT(file.problems, ::testing::IsEmpty());
  const auto parsed = document->load_string(file.text.c_str());
  EXPECT_TRUE(parsed) << parsed.description() << "\n" << file.text;
  for (const std::string& remark : file.remarks) {
    EXPECT_THAT(file.text, ::testing::HasSubstr(remark));
  }
}

double NumberOf(const pugi::xml_node& parent, const std::string& name) {
  EXPECT_TRUE(parent.child(name.c_str())) << name;
  return parent.child(name.c_str()).text().as_double(NAN);
}

Eigen::VectorXd NumbersIn(const std::string& text) {
  std::istringstream stream(text);
  std::vector<double> numbers;
  for (double number = 0.0; stream >> number;) numbers.push_back(number);
  return Eigen::Map<Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
}

Eigen::MatrixXd SymmetricOf(const pugi::xml_node& parent,
                            const std::string& prefix,
                            const std::string& letters) {
  const auto n = static_cast<Eigen::Index>(letters.size());
  Eigen::MatrixXd matrix(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = i; j < n; ++j) {
      const std::string name =
          prefix + letters[static_cast<std::size_t>(i)] + letters[static_cast<std::size_t>(j)];
      matrix(i, j) = matrix(j, i) = NumberOf(parent, name);
    }
  }
  return matrix;
}

Matrix6 BodyInertiaIn(const pugi::xml_node& inertial) {
  const double mass = NumberOf(inertial, "mass");
  const Eigen::Vector3d centre = NumbersIn(inertial.child("pose").text().as_string()).head<3>();
  const Eigen::Matrix3d cross = CrossMatrix(centre);
  Matrix6 inertia;
  inertia << mass * Eigen::Matrix3d::Identity(), -mass * cross, mass * cross,
      SymmetricOf(inertial.child("inertia"), "i", "xyz") - mass * cross * cross;
  return inertia;
}

std::set<std::string> NamesBelow(const pugi::xml_node& node) {
  std::set<std::string> names;
  for (const pugi::xml_node& child : node.children()) {
    if (child.type() != pugi::node_element) continue;
    names.insert(child.name());
    names.merge(NamesBelow(child));
  }
  return names;
}

}  // namespace fathom
