// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/exporting/export_format.h"
#include "fathom/exporting/export_model.h"
#include "fathom/exporting/export_target.h"
#include "fathom/vehicle/coupled/rigid_body.h"
#include "fathom/vehicle/coupled/six_vector.h"

#include <string>
#include <vector>

namespace fathom {

// The body and its added mass apart, as simulators of bodies want them: M = M_rigid + M_A.
struct SplitInertia {
  RigidBody body;                        // all of it but volume and centre of buoyancy
  Matrix6 added_mass = Matrix6::Zero();  // M_A, 0 where the model tells nothing
  std::vector<std::string> problems;     // M_A below 0 on the diagonal; M_rigid + M_A
};

// M_A is M - M_rigid between modelled DOFs (of models of one DOF each: on the diagonal alone).
// Throws InputError without the vehicle's mass, inertia tensor and centre of mass, and where
// `needs_size` without its size, saying which are missing and how to write them.
SplitInertia SplitInertiaOf(const ExportModel& model,
                            const ExportTarget& target,
                            ExportFormat format,
                            bool needs_size = false);

// A matrix of forces by velocities or accelerations, from x forward, y starboard, z down into x
// forward, y port, z up, and back: rows and columns of y, z, pitch and yaw change sign.
Matrix6 InAxesZUp(const Matrix6& matrix);
Eigen::Vector3d InAxesZUp(const Eigen::Vector3d& vector);

}  // namespace fathom
