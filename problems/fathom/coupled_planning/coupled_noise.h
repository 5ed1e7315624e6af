// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled_planning/coupled_plan.h"
#include "fathom/coupled_planning/wrench_run.h"

namespace fathom {

// How the velocities will be measured: as the limits say, else as the fit shows it. Throws
// InputError where neither does.
void SetMeasurement(const CoupledPlanRequest& request, CoupledPlan* plan);

// The same at the stamps of a search. A stamp stands for the velocities measured in its period, and
// a window of the fit holds one at least. Throws InputError for a colour that does not die away.
WrenchMeasurement MeasurementFor(const CoupledPlanRequest& request, const CoupledPlan& plan);

// The noise of one velocity of a DOF of the model, over samples. Throws as MeasurementFor() does.
Autoregression NoiseOfSample(const CoupledPlanRequest& request, const CoupledPlan& plan, Dof dof);

// How often a fit begins its simulation anew, as far as the model's file says [s].
double WindowOf(const CoupledPlanRequest& request);

}  // namespace fathom
