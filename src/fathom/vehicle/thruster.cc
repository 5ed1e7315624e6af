// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/thruster.h"

#include <cmath>

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

Eigen::Matrix<double, 6, 1> GeneralisedForces(
    const Eigen::Matrix<double, 6, Eigen::Dynamic>& allocation, const Eigen::VectorXd& thrusts) {
  constexpr double kRounding = 1e-12;  // of what is added and taken away
  Eigen::Matrix<double, 6, 1> forces = allocation * thrusts;
  const Eigen::Matrix<double, 6, 1> sizes = allocation.cwiseAbs() * thrusts.cwiseAbs();
  for (int i = 0; i < 6; ++i) {
    if (std::abs(forces(i)) <= kRounding * sizes(i)) forces(i) = 0.0;
  }
  return forces;
}

}  // namespace fathom
