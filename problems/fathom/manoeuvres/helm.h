// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/log.h"
#include "fathom/manoeuvres/measured_gear.h"
#include "fathom/simulate/coupled/coupled_inputs.h"
#include "fathom/simulate/coupled/manoeuvre_run.h"
#include "fathom/vehicle/coupled/coupled_model.h"

#include <optional>
#include <vector>

namespace fathom {

// How a log's vehicle is steered and driven.
struct Helm {
  std::vector<CommandedFin> fins;
  ManoeuvreOptions driven;       // speed at the begin, mean force, the rudder's rate and delay
  double thrust = 0.0;           // the force ahead at that speed, of shafts too [N]
  double race = 0.0;             // what makes a race of it [N]
  std::optional<double> length;  // of the vehicle [m], where its file tells
  std::optional<ManoeuvreTrack> logged;  // LoggedTrack() of the rudder
  std::optional<MeasuredGear> gear;      // GearOf() it
};

// From the log's first speed on, under its mean force ahead, its rudder as GearOf() finds it, or as
// quick as it ever is where that finds none. The track's step is a sixtieth of length over speed,
// 0.1 s at least, and it lasts 6000 steps at most.
//
// Throws InputError if the log does not begin with a speed ahead, and what CoupledDataOf() throws.
Helm HelmOf(const CoupledModel& model, const Log& log);

}  // namespace fathom
