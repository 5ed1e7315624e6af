// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/vehicle/vehicle_file.h"

#include <array>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// How a vehicle moves and where it is: docs/notation.md.
struct MotionState {
  Eigen::Matrix<double, 6, 1> velocity = Eigen::Matrix<double, 6, 1>::Zero();  // nu, body frame
  Eigen::Matrix<double, 6, 1> travel = Eigen::Matrix<double, 6, 1>::Zero();    // integral of nu
  Eigen::Vector3d body_in_world = Eigen::Vector3d::Zero();                     // [m]
  Eigen::Vector4d world_from_body{0.0, 0.0, 0.0, 1.0};  // unit quaternion x, y, z, w
};

// The motion of a vehicle whose driven DOFs follow the uncoupled model each, the others held; the
// pose follows from all of them together.
//
//   m dv/dt + d_Q v|v| + d_L v + b = tau                     docs/models.md (1)
//   dp/dt = R(q) v,   dq/dt = q * (omega, 0) / 2             docs/synthesize.md (9)
//
// Integrated by the classical Runge-Kutta scheme in steps of its own, at most 5 ms and a twentieth
// of the damping's time constant: independent of class Simulation, so that each can test the other.
class VehicleMotion {
 public:
  // The vehicle has a model of each of the DOFs.
  VehicleMotion(const Vehicle& vehicle, const std::vector<Dof>& driven);

  // The state `duration` seconds later under constant forces, by Index(Dof) [N] or [N m]. Throws
  // InputError if the numbers leave what a double holds, or a damping's time constant is below 0.2
  // ms.
  MotionState After(const MotionState& state,
                    const std::array<double, 6>& force,
                    double duration) const;

 private:
  std::string vehicle_name_;
  std::vector<Dof> driven_;
  std::array<UncoupledModel<double>, 6> models_;
};

}  // namespace fathom
