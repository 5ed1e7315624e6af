// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/sampled_signal.h"
#include "fathom/vehicle/coupled/fin_force.h"
#include "fathom/vehicle/coupled/six_vector.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace fathom {

// A thruster as a run of a coupled model takes it.
struct CommandedThruster {
  std::string name;                 // as CoupledModel::thrust_gain names it
  Vector6 push = Vector6::Zero();   // forces and moments of a thrust of 1 N: its column of B
  std::vector<double> thrust = {};  // [N], held, at CoupledCommand::time
};

// A fin as a run of a coupled model takes it.
struct CommandedFin {
  std::string name;  // as CoupledModel::fin_force names it
  FinArms arms;
  std::vector<double> angle = {};  // [rad], held, at CoupledCommand::time
  std::string behind = {};         // the thruster in whose race it stands, or any name: all thrust
                                   // along x; empty: none
  std::optional<double> force = {};  // f, where the vehicle file tells it
};

// What drives a vehicle: a row at each stamp, held until the next. Before the first: nothing.
struct CoupledCommand {
  std::vector<double> time;         // [s], strictly increasing
  std::vector<Vector6> force = {};  // [N], [N m], beside the thrusters; empty: none
  std::vector<CommandedThruster> thrusters = {};
  std::vector<CommandedFin> fins = {};
};

// The thrust ahead whose race a fin stands in, at a row of the command [N], gains of 1; at least 0.
double RaceThrust(const CoupledCommand& command, const CommandedFin& fin, std::size_t row);

// What a run of a coupled model takes from a log.
struct CoupledInputs {
  CoupledCommand command;

  // By Index(Dof), of DOFs that are not modelled: the measured velocities, joined on straight lines
  // and held beyond their ends. Empty: the DOF holds still.
  std::array<SampledSignal, 6> measured = {};
};

}  // namespace fathom
