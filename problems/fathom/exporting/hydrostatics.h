// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/exporting/export_model.h"
#include "fathom/vehicle/coupled/rigid_body.h"

#include <string>
#include <vector>

#include <Eigen/Core>

namespace fathom {

inline constexpr double kWaterDensity = 1000.0;  // of the exported files [kg/m^3]

// What a simulator of bodies takes instead of net buoyancy, righting moments and their trim: a
// volume of water and its centre, body frame.
//
//   B = W + b,   K = W z_g - B z_b,   o_roll = B y_b - W y_g,   o_pitch = W x_g - B x_b
//
// One centre has one K: the mean, where those of roll and pitch differ; 0 where none is known.
// Fossen 2021, Section 4.1.
struct Hydrostatics {
  double weight = 0.0;    // W [N]
  double buoyancy = 0.0;  // B [N]
  double volume = 0.0;    // [m^3]
  Eigen::Vector3d centre_of_buoyancy = Eigen::Vector3d::Zero();
  std::vector<std::string> remarks;  // what is not known, a sentence each

  // Where the vehicle would rest elsewhere than the model does, by more than a degree.
  std::vector<std::string> problems;
};

// `body`: mass and centre of mass are known. `gravity`: of the simulator [m/s^2].
Hydrostatics HydrostaticsOf(const ExportModel& model, const RigidBody& body, double gravity);

}  // namespace fathom
