// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/sampled_signal.h"
#include "fathom/vehicle/coupled/coupled_model.h"
#include "fathom/vehicle/coupled/fin_force.h"
#include "fathom/vehicle/coupled/six_vector.h"
#include "fathom/vehicle/shaft.h"

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
  std::vector<double> angle = {};    // [rad], held, at CoupledCommand::time
  std::string behind = {};           // the thruster or shaft in whose race it stands, or any name:
                                     // all thrust along x; empty: none
  std::optional<double> force = {};  // f, where the vehicle file tells it
};

// A shaft as a run of a coupled model takes it.
struct CommandedShaft {
  Shaft shaft;                     // CoupledModel::thrust_gain names it too
  Vector6 push = Vector6::Zero();  // forces and moments of 1 N; times nu the speed at it
  std::vector<double> turns = {};  // [Hz], held, at CoupledCommand::time
};

// A shaft of the vehicle, without turns.
CommandedShaft CommandedShaftOf(const Shaft& shaft);

// What it gives the vehicle, (1 - t) T, at a velocity of the vehicle.
ShaftThrust ThrustOnVehicle(const CommandedShaft& shaft, double turns, const Vector6& nu);

// What drives a vehicle: a row at each stamp, held until the next. Before the first: nothing.
struct CoupledCommand {
  std::vector<double> time;         // [s], strictly increasing
  std::vector<Vector6> force = {};  // [N], [N m], beside the thrusters; empty: none
  std::vector<CommandedThruster> thrusters = {};
  std::vector<CommandedFin> fins = {};
  std::vector<CommandedShaft> shafts = {};
};

// The thrust ahead of thrusters and forces whose race a fin stands in, at a row of the command [N],
// gains of 1; at least 0.
double RaceThrust(const CoupledCommand& command, const CommandedFin& fin, std::size_t row);

// The shafts whose race it stands in: the one that it names, none where it names a thruster, else
// all.
std::vector<std::size_t> RaceShafts(const CoupledCommand& command, const CommandedFin& fin);

// The same of thrusters, forces and shafts, at a velocity; of a shaft the propeller's own thrust.
double RaceThrust(const CoupledCommand& command,
                  const CommandedFin& fin,
                  std::size_t row,
                  const Vector6& nu);

// What the shafts give at a row of the command, with the gains of a model; or at a gain of 1 the
// one of this name.
Vector6 ShaftForces(const CoupledCommand& command,
                    std::size_t row,
                    const Vector6& nu,
                    const CoupledModel& model,
                    const std::string* only = nullptr);

// What a run of a coupled model takes from a log.
struct CoupledInputs {
  CoupledCommand command;
  std::string log = {};  // its name, by which CoupledModel::current knows it

  // By Index(Dof), of DOFs that are not modelled: the measured velocities, joined on straight lines
  // and held beyond their ends. Empty: the DOF holds still.
  std::array<SampledSignal, 6> measured = {};
};

}  // namespace fathom
