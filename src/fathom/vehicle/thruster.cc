// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/thruster.h"

#include <Eigen/Geometry>

namespace fathom {

Eigen::Matrix<double, 6, Eigen::Dynamic> AllocationMatrix(const std::vector<Thruster>& thrusters) {
  Eigen::Matrix<double, 6, Eigen::Dynamic> allocation(6, thrusters.size());
  Eigen::Index column = 0;
  for (const Thruster& thruster : thrusters) {
    allocation.col(column++) << thruster.direction, thruster.position.cross(thruster.direction);
  }
  return allocation;
}

}  // namespace fathom
