// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>

#include <Eigen/Core>

namespace fathom {

// A fin or rudder that turns about its span.
struct Fin {
  std::string name;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // of its pressure, body frame [m]
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();     // the span, outward, length 1; not along x

  // Where known. A positive angle turns by the right-hand rule about the axis.
  std::optional<double> area;           // [m^2], above 0
  std::optional<double> lift_slope;     // dC_L/dangle [1/rad], above 0
  std::optional<double> largest_angle;  // [rad], above 0
  std::string behind = {};              // the shaft in whose race it stands; may be empty
};

// Along which a small positive angle pushes while the vehicle moves ahead: axis x forward,
// length 1.
Eigen::Vector3d AcrossFin(const Fin& fin);

// rho/2 A dC_L/dangle [N s^2/m^2 a radian] in fresh water; nothing where the file does not tell it.
std::optional<double> FinForceOf(const Fin& fin);

}  // namespace fathom
