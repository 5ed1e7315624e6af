// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/fin.h"

#include <Eigen/Geometry>

namespace fathom {

Eigen::Vector3d AcrossFin(const Fin& fin) {
  return fin.axis.cross(Eigen::Vector3d::UnitX()).normalized();
}

std::optional<double> FinForceOf(const Fin& fin) {
  constexpr double kWaterDensity = 1000.0;  // [kg/m^3]
  if (!fin.area || !fin.lift_slope) return std::nullopt;
  return 0.5 * kWaterDensity * *fin.area * *fin.lift_slope;
}

}  // namespace fathom
