// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// A propeller in a fixed place on the vehicle.
//
//   T = C_t Omega |Omega|                                    docs/models.md (3)
//
//   T      thrust along `direction`                          [N]
//   Omega  speed of the propeller, signed                    [Hz]
//   C_t    thrust coefficient, one for each sense            [N s^2]
//
// Static thrust in still water: no inflow, no lag, no dead zone.
struct Thruster {
  std::string name;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();    // in the body frame [m]
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  // of positive thrust, body frame, length 1
  double forward_coefficient = 0.0;                      // C_t for Omega > 0 [N s^2]; 0: not known
  double reverse_coefficient = 0.0;                      // C_t for Omega < 0 [N s^2], at least 0

  // Of the vehicle, by name, instead of the coefficients; may be empty.
  std::string thrust_table = {};

  double Thrust(double speed) const {
    return (speed < 0.0 ? reverse_coefficient : forward_coefficient) * speed * std::abs(speed);
  }
};

// Generalised forces of unit thrusts, a column for each thruster.
//
//   tau = B T,   column of B: (d, p x d)                      docs/models.md (4)
//
// Rows in the order of Dof: surge, sway, heave [N], roll, pitch, yaw [N m] about the body's origin.
Eigen::Matrix<double, 6, Eigen::Dynamic> AllocationMatrix(const std::vector<Thruster>& thrusters);

// B T. Exactly 0 where thrusts cancel: what rounding leaves of them would look like a command.
Eigen::Matrix<double, 6, 1> GeneralisedForces(
    const Eigen::Matrix<double, 6, Eigen::Dynamic>& allocation, const Eigen::VectorXd& thrusts);

}  // namespace fathom
