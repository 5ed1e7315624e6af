// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/simulate/coupled/coupled_inputs.h"
#include "fathom/simulate/coupled/coupled_simulation.h"
#include "fathom/synthesize/experiment/experiment.h"
#include "fathom/vehicle/coupled/coupled_model.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <cstdint>
#include <string>
#include <vector>

namespace fathom {

// A coupled vehicle's way through an experiment: what drives it, and from where. Its motion is that
// of RunCoupled(), the simulation that fits and predictions use.
struct CoupledTruth {
  std::string vehicle;  // its name
  CoupledModel model;
  CoupledInputs inputs;  // stamps since the start [s]; every fin of the vehicle
  CoupledState start;
};

// Drives the vehicle, which has a coupled model, through the experiment. A controller takes the
// place in the world: z for heave, roll, pitch and yaw of the attitude for the others.
//
// Throws InputError if the experiment drives a DOF that the model does not move, a thruster or fin
// that the vehicle does not have, surge or sway in closed loop, or turbulence.
CoupledTruth DriveCoupled(const Vehicle& vehicle, const Experiment& experiment, std::uint64_t seed);

// The velocities and places at such times since the start [s], which increase. Throw InputError if
// the motion leaves the finite numbers or is too quick for the simulation.
std::vector<Vector6> VelocitiesAt(const CoupledTruth& truth, const std::vector<double>& time);
std::vector<CoupledState> PlacesAt(const CoupledTruth& truth, const std::vector<double>& time);

}  // namespace fathom
