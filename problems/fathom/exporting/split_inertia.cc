// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/exporting/split_inertia.h"

#include "fathom/base/input_error.h"

#include <Eigen/Cholesky>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

RigidBody RequireRigidBody(const ExportTarget& target, ExportFormat format, bool needs_size) {
  const RigidBody body = target.vehicle ? target.vehicle->body : RigidBody();
  std::vector<std::string> names, missing;
  if (!body.mass) {
    names.push_back("'mass'");
    missing.push_back("mass: 13.5");
  }
  if (needs_size && !(target.vehicle && target.vehicle->size)) {
    names.push_back("'size'");
    missing.push_back("size: [0.46, 0.58, 0.25]");
  }
  std::vector<std::string> keys;
  if (!body.inertia_tensor) {
    names.push_back("'rigid_body.inertia_tensor'");
    keys.push_back("inertia_tensor: [[0.4, 0, 0], [0, 0.6, 0], [0, 0, 0.8]]");
  }
  if (!body.centre_of_mass) {
    names.push_back("'rigid_body.centre_of_mass'");
    keys.push_back("centre_of_mass: [0, 0, 0.02]");
  }
  if (!keys.empty()) {
    missing.push_back(fmt::format("rigid_body: {{{}}}", fmt::join(keys, ", ")));
  }
  if (missing.empty()) return body;
  throw InputError(fmt::format(
      "{}: {}. --format={} wants the body and its added mass apart: expected `{}` in the "
      "vehicle file, with your own numbers (about the body's origin; docs/file_formats.md).",
      NameOfVehicleFile(target),
      target.vehicle ? fmt::format("has no key {}", fmt::join(names, ", nor ")) : "is missing",
      Name(format),
      fmt::join(missing, "` and `")));
}

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

std::vector<std::string> ProblemsWithAddedMass(const ExportModel& model,
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

// Whether an axis keeps its sense, x and roll do. 0 for -0.
double Turned(double value, int axis) {
  return axis == 0 || axis == 3 || value == 0.0 ? value : -value;
}

}  // namespace

SplitInertia SplitInertiaOf(const ExportModel& model,
                            const ExportTarget& target,
                            ExportFormat format,
                            bool needs_size) {
  SplitInertia split;
  split.body = RequireRigidBody(target, format, needs_size);
  const Matrix6 rigid = *RigidInertia(split.body);
  split.added_mass = AddedMassOf(model, rigid);
  split.problems = ProblemsWithAddedMass(model, rigid, split.added_mass);
  return split;
}

Matrix6 InAxesZUp(const Matrix6& matrix) {
  Matrix6 turned;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) turned(i, j) = Turned(Turned(matrix(i, j), i), j);
  }
  return turned;
}

Eigen::Vector3d InAxesZUp(const Eigen::Vector3d& vector) {
  return {vector[0], Turned(vector[1], 1), Turned(vector[2], 2)};
}

}  // namespace fathom
