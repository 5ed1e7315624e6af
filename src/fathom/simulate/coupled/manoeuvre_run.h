// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/simulate/coupled/coupled_inputs.h"
#include "fathom/simulate/coupled/coupled_simulation.h"
#include "fathom/simulate/coupled/helmsman.h"
#include "fathom/simulate/coupled/manoeuvre.h"
#include "fathom/vehicle/coupled/coupled_model.h"

#include <limits>
#include <optional>
#include <vector>

namespace fathom {

struct ManoeuvreOptions {
  double ahead = 1.0;               // speed at the begin [m/s], above 0
  Vector6 force = Vector6::Zero();  // that drives it throughout, of thrusters too [N], [N m]
  double thrust = 0.0;              // of it what makes a race [N]
  std::vector<CommandedShaft> shafts = {};  // beside it, each at one number of turns
  // With which the order to the rudder moves [rad/s], above 0.
  double rudder_rate = std::numeric_limits<double>::infinity();
  double rudder_delay = 0.0;  // of a zigzag, from the heading's reaching the order to the rudder's
                              // answer [s], at least 0
  double step = 0.1;          // between the samples of the track [s], above 0
  double longest = 600.0;     // [s]; a third of it for each order of a spiral or a pull-out
};

struct ManoeuvreTrack {
  std::vector<double> time;     // [s], every ManoeuvreOptions::step
  std::vector<double> angle;    // of the rudder [rad], as the fin counts it
  double fin_sign = 1.0;        // of an angle that turns to starboard
  std::vector<double> heading;  // unwrapped, to starboard [rad]
  std::vector<CoupledState> state;
  std::vector<SteadyTurn> steady = {};  // of a spiral and a pull-out: one for each order
};

// The rate with which the rudder turns: that of the order, or what the model limits it to [rad/s].
double RudderRate(const CoupledModel& model,
                  const std::vector<CommandedFin>& fins,
                  const ManoeuvreOptions& options);

// Runs a manoeuvre until its figures are known, with the fin that turns the vehicle most. A stop
// takes `force` along x astern, without a race, and of shafts the turns by the root of the share.
// Nothing if there is no such fin, but of a stop, or if the run diverges.
std::optional<ManoeuvreTrack> RunManoeuvre(const CoupledModel& model,
                                           const std::vector<CommandedFin>& fins,
                                           const Manoeuvre& manoeuvre,
                                           const ManoeuvreOptions& options);

}  // namespace fathom
