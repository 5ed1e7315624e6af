// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/synthesize/experiment/turbulence.h"
#include "fathom/synthesize/motion/hidden_effects.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <array>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// One number for each hidden effect, all DOFs together; on the stack.
using EffectStates = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 16, 1>;

// How a vehicle moves and where it is: docs/notation.md.
struct MotionState {
  Eigen::Matrix<double, 6, 1> velocity = Eigen::Matrix<double, 6, 1>::Zero();  // nu, body frame
  Eigen::Matrix<double, 6, 1> travel = Eigen::Matrix<double, 6, 1>::Zero();    // integral of nu
  Eigen::Vector3d body_in_world = Eigen::Vector3d::Zero();                     // [m]
  Eigen::Vector4d world_from_body{0.0, 0.0, 0.0, 1.0};  // unit quaternion x, y, z, w
  EffectStates thrust;                                  // of effects that follow the command
  EffectStates memory;                                  // of effects with a state in the water
};

// The commands that hold over a while, by Index(Dof) [N] or [N m].
struct HeldForces {
  std::array<double, 6> sent{};     // as logged at this time
  std::array<double, 6> arrived{};  // what the actuators act on: sent, less the delay on the way
};

// `force` sent and arrived.
inline HeldForces Undelayed(const std::array<double, 6>& force) { return {force, force}; }

// The motion of a vehicle whose driven DOFs follow the uncoupled model each, with what is hidden in
// them, the others held; the pose follows from all of them together.
//
//   m dv/dt + d_Q v|v| + d_L v + b = tau                     docs/models.md (1)
//   dp/dt = R(q) v,   dq/dt = q * (omega, 0) / 2             docs/synthesize.md (9)
//
// Integrated by the classical Runge-Kutta scheme in steps of its own, at most 5 ms and a twentieth
// of the quickest time constant: independent of class Simulation, so that each can test the other.
class VehicleMotion {
 public:
  // The vehicle has a model of each of the DOFs; the effects are of those DOFs, 16 at most.
  VehicleMotion(const Vehicle& vehicle,
                const std::vector<Dof>& driven,
                std::span<const ActiveEffect> effects = {},
                const std::array<Turbulence, 6>& turbulence = {});

  // At rest or at some speed [m/s] or [rad/s], with nothing commanded before.
  MotionState Start(const std::array<double, 6>& speed) const;

  // The state at `start + duration`, from the one at `start`, under held commands. Throws
  // InputError if the numbers leave what a double holds, or a time constant is below 0.2 ms.
  MotionState After(const MotionState& state,
                    const HeldForces& held,
                    double start,
                    double duration) const;

  const HiddenEffects& hidden(Dof dof) const { return hidden_[Index(dof)]; }

 private:
  MotionState Slope(const MotionState& now,
                    const HeldForces& held,
                    const std::array<double, 6>& force,
                    double time) const;
  double LongestStep(const MotionState& now, const HeldForces& held, double time) const;
  double Acceleration(Dof dof,
                      double speed,
                      const MotionState& now,
                      const HeldForces& held,
                      double force,
                      double time) const;

  std::string vehicle_name_;
  std::vector<Dof> driven_;
  std::array<UncoupledModel<double>, 6> models_;
  std::array<HiddenEffects, 6> hidden_;
  std::array<int, 6> first_effect_{};  // of each DOF, in EffectStates
  int num_effects_ = 0;
  std::array<Turbulence, 6> turbulence_;
};

}  // namespace fathom
