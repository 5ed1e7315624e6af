// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/simulate/coupled/coupled_inputs.h"
#include "fathom/vehicle/coupled/coupled_model.h"
#include "fathom/vehicle/coupled/free_entry.h"
#include "fathom/vehicle/coupled/six_vector.h"

#include <span>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// Where a vehicle is and how it moves.
struct CoupledState {
  Vector6 nu = Vector6::Zero();                        // body frame; of modelled DOFs
  Eigen::Vector4d attitude = {0.0, 0.0, 0.0, 1.0};     // world_from_body: x, y, z, w
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // world [m]
};

// When the run starts and where its outputs are wanted, in log time [s]: strictly increasing, from
// the start on.
struct CoupledStamps {
  double start = 0.0;
  std::vector<double> velocity;
  std::vector<double> pose;
};

// What the sensors would show.
struct CoupledOutputs {
  std::vector<Vector6> velocity;   // at CoupledStamps::velocity; DOFs not modelled as measured
  std::vector<CoupledState> pose;  // at CoupledStamps::pose
  int num_steps = 0;

  // Six rows for each stamp: of the velocity by Index(Dof); of the pose a small turn in the body
  // frame [rad], then the position in the world [m]. Columns: the entries, the velocities at the
  // start of the modelled DOFs, and a small turn at the start in the body frame.
  using Sensitivity = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Sensitivity velocity_sensitivity;
  Sensitivity pose_sensitivity;
};

// Columns of the sensitivities.
int NumCoupledColumns(const CoupledModel& model, std::span<const FreeEntry> entries);

// How long the steps of a run may be. A state that stays is exact in steps of any length.
struct CoupledSteps {
  double longest = 0.05;                 // [s]
  double share_of_time_constant = 0.25;  // of the quickest, at most
};

// Runs docs/coupled.md (1) from a state over a command, by the classical Runge-Kutta scheme in
// steps within these limits, none across a change of the command. Outputs lie on the cubic through
// both ends of their step.
//
// Returns false if the inertia of the modelled DOFs is not positive definite, or if the state
// leaves the finite numbers; the outputs then mean nothing.
bool RunCoupled(const CoupledModel& model,
                const CoupledInputs& inputs,
                const CoupledState& start,
                const CoupledStamps& stamps,
                CoupledOutputs* outputs,
                const CoupledSteps& steps = {});

// The same, with the sensitivities by the variational equation, docs/coupled.md (5). Every entry is
// one of modelled DOFs.
bool RunCoupledWithSensitivities(const CoupledModel& model,
                                 std::span<const FreeEntry> entries,
                                 const CoupledInputs& inputs,
                                 const CoupledState& start,
                                 const CoupledStamps& stamps,
                                 CoupledOutputs* outputs);

}  // namespace fathom
