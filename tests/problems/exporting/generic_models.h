// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/exporting/export_model.h"
#include "fathom/exporting/export_target.h"
#include "fathom/vehicle/coupled/fitted_coupled_model.h"
#include "fathom/vehicle/fitted_model.h"

namespace fathom {

// Small vehicles whose numbers hide nothing: no 0 where there could be one, none alike.

// All six DOFs and every number that a model can have, but for most of the quadratic damping off
// the diagonal.
FittedCoupledModel GenericRov();

// Surge, sway and yaw with C(nu) and the couplings of a boat.
FittedCoupledModel GenericBoat();

// That boat with a friction, drags that are no square, a dead zone and a weakness astern.
FittedCoupledModel GenericBoatWithEffects();

// One DOF.
FittedModel GenericOneDof(Dof dof);

// Of 30 kg, with its rigid body and its size.
ExportTarget GenericTarget();

}  // namespace fathom
