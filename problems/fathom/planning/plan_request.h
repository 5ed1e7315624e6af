// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/planning/plan_limits.h"
#include "fathom/planning/rival_model.h"
#include "fathom/planning/thruster_allocation.h"
#include "fathom/signal/segment.h"
#include "fathom/vehicle/fitted_model.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace fathom {

// What an experiment is planned from.
struct PlanRequest {
  FittedModel model;  // what is known so far
  std::string name;   // of its file, for messages
  PlanLimits limits;
  bool limits_are_of_log = false;  // LimitsOfLog(): no limits file was given
  double duration = 0.0;           // [s]
  std::uint64_t seed = 1;
  double effort = 1.0;  // share of the trials of a full search, above 0 to 1

  // That give the force, and the name of their vehicle's file, where one was given.
  std::optional<ThrusterAllocation> thrusters = {};
  std::string vehicle = {};

  // Of logs of the vehicle that the model was not fitted to: what they tell need not be flown
  // again.
  std::vector<Segment> flown = {};

  // All explanations that the log leaves open, where it leaves several: at least two, or none.
  std::vector<RivalModel> rivals = {};
};

// Throws InputError for effects that need another DOF or poses; `name`: of the model's file.
void RequireOwnEffects(const ExtendedModel& model, Dof dof, const std::string& name);

// Throws InputError for commands in another unit than N or N m, and for effects that need another
// DOF or poses.
void RequirePlannable(const PlanRequest& request);

// Throws InputError if the force of the limits is more than the thrusters give; of limits that are
// those of the log, it is lowered to that instead. `limits_name`: of their file, for messages.
void FitForceToThrusters(const std::string& limits_name, PlanRequest* request);

// How the velocity will be measured: as the limits say, else as the model's fit shows it. Throws
// InputError where neither does.
VelocityMeasurement MeasurementOf(const PlanRequest& request);

// The colour of the velocity's noise over samples, as the fit of the model found it; none where the
// limits say how large the noise is, or where causes are open: what a wrong cause misses is
// coloured.
std::vector<double> ColourOf(const PlanRequest& request);

}  // namespace fathom
