// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/simulate/coupled/coupled_simulation.h"

#include <cstddef>
#include <vector>

namespace fathom {

// A small ROV with couplings, all of them.
CoupledModel Rov();

// With a friction, drags that are no square, and a wrench that loses some of what is commanded.
CoupledModel RovWithEffects();

// Steps of 2 s of two thrusters, beside forces.
CoupledInputs Steps(int num_steps);

// The wrench of a row of them.
Vector6 ForceOf(const CoupledModel& model, const CoupledInputs& inputs, std::size_t row);

CoupledState Moving();

// With a rudder at the stern behind the port thruster, a stern plane outside of its race, and a fin
// that no command turns.
Fin Rudder();
Fin SternPlane();
Fin StuckPlane();
CoupledModel FinnedRov();
CoupledInputs FinnedSteps(int num_steps);

// With a shaft off the centre line beside them, of which the model knows 0.7 of the thrust: ahead,
// astern and stopped. The rudder stands in its race.
Shaft Screw();
CoupledModel ScrewedRov();
CoupledInputs ScrewedSteps(int num_steps);

}  // namespace fathom
