// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/exporting/export_model.h"
#include "fathom/exporting/export_target.h"
#include "fathom/vehicle/coupled/six_vector.h"

namespace fathom {

// A model of SDF 1.10 with one link, for Gazebo from Garden (gz-sim 7) on: mass, inertia and
// <fluid_added_mass> in its <inertial>, and the plugin gz::sim::systems::Hydrodynamics with the
// dampings, at most 0 where they take energy. Never xDotU and its like: the plugin changed their
// sign between versions. Gazebo's body is x forward, y port, z up. docs/export.md.
//
// The added mass is M - M_rigid between modelled DOFs (of models of one DOF each: on the diagonal
// alone), else 0. `problems`: where it is below 0 on the diagonal, or the sum with M_rigid is not
// positive definite.
//
// Throws InputError without the vehicle's mass, inertia tensor and centre of mass, saying which are
// missing and how to write them, and where commands are not in newtons.
ExportedFile GazeboModel(const ExportModel& model, const ExportTarget& target);

// A matrix of forces by velocities or accelerations, from x forward, y starboard, z down into x
// forward, y port, z up, and back: rows and columns of y, z, pitch and yaw change sign.
Matrix6 InAxesZUp(const Matrix6& matrix);

}  // namespace fathom
