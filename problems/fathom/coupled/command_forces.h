// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled/fin_angles.h"
#include "fathom/simulate/coupled/coupled_inputs.h"
#include "fathom/vehicle/coupled/coupled_model.h"
#include "fathom/vehicle/coupled/free_entry.h"
#include "fathom/vehicle/coupled/six_vector.h"

namespace fathom {

// What a command gives a vehicle by the numbers of a model, at the time `t` [s] and a velocity; and
// what a unit of one entry changes it by, to first order. A lag counts as a delay, which it is to
// first order. Before the first row of the command: nothing.

// Of wrench and thrusters, over a time [N s], [N m s].
Vector6 ThrustImpulse(const CoupledCommand& command,
                      double from,
                      double to,
                      const CoupledModel& model);
// 0 of entries that are none of theirs.
Vector6 ThrustImpulseBy(const FreeEntry& entry,
                        const CoupledCommand& command,
                        double from,
                        double to,
                        const CoupledModel& model);

// Of the shafts [N], [N m].
Vector6 ShaftForcesAt(const CoupledCommand& command,
                      double t,
                      const Vector6& nu,
                      const CoupledModel& model);
// By a thrust gain; 0 of other entries.
Vector6 ShaftForcesBy(const FreeEntry& entry,
                      const CoupledCommand& command,
                      double t,
                      const Vector6& nu,
                      const CoupledModel& model);

// Of the fins [N], [N m], with their angles by the same command and model.
Vector6 FinForcesAt(const CoupledCommand& command,
                    const FinAngles& angles,
                    double t,
                    const Vector6& nu,
                    const CoupledModel& model);
// By a force or an angle of a fin; 0 of other entries.
Vector6 FinForcesBy(const FreeEntry& entry,
                    const CoupledCommand& command,
                    const FinAngles& angles,
                    double t,
                    const Vector6& nu,
                    const CoupledModel& model);
// Of the fins that an entry delays.
Vector6 FinForcesLater(const FreeEntry& entry,
                       const CoupledCommand& command,
                       const FinAngles& angles,
                       double t,
                       const Vector6& nu,
                       const CoupledModel& model);

}  // namespace fathom
