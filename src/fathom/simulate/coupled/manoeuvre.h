// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/simulate/coupled/coupled_inputs.h"
#include "fathom/simulate/coupled/coupled_simulation.h"
#include "fathom/vehicle/coupled/coupled_model.h"

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// A standard manoeuvre of a vehicle that steers with a rudder; IMO MSC.137(76), ITTC 7.5-02-06-01.
struct Manoeuvre {
  enum class Kind {
    kTurningCircle,  // the rudder to starboard, and held
    kZigzag,  // the rudder to starboard and, whenever the heading reaches it, to the other side
  };
  Kind kind = Kind::kTurningCircle;
  double angle = 0.0;    // of the rudder, above 0 [rad]
  double heading = 0.0;  // of a zigzag, above 0 [rad]
};

// "turning_circle:35", "zigzag:10/10", in degrees. Throws InputError, with what is expected, for
// anything else.
Manoeuvre ParseManoeuvre(std::string_view text);

struct ManoeuvreOptions {
  double ahead = 1.0;               // speed at the begin [m/s], above 0
  Vector6 force = Vector6::Zero();  // that drives it throughout, of thrusters too [N], [N m]
  double thrust = 0.0;              // of it what makes a race [N]
  double rudder_rate = std::numeric_limits<double>::infinity();  // [rad/s], above 0
  double longest = 600.0;                                        // [s]
};

struct ManoeuvreTrack {
  std::vector<double> time;     // [s], every 0.1 s
  std::vector<double> angle;    // of the rudder [rad], as the fin counts it
  std::vector<double> heading;  // unwrapped, to starboard [rad]
  std::vector<CoupledState> state;
};

// Runs a manoeuvre until its figures are known, with the fin that turns the vehicle most. Nothing
// if there is none, or if the run diverges.
std::optional<ManoeuvreTrack> RunManoeuvre(const CoupledModel& model,
                                           const std::vector<CommandedFin>& fins,
                                           const Manoeuvre& manoeuvre,
                                           const ManoeuvreOptions& options);

// A number by which a manoeuvre is judged; NaN where the run did not come so far.
struct ManoeuvreFigure {
  std::string name;  // "tactical_diameter"
  double value = std::numeric_limits<double>::quiet_NaN();
  std::string unit;  // "m"
};

// Of a turning circle advance, transfer, tactical diameter, steady radius and speed; of a zigzag
// the first two overshoot angles [deg] and the period.
std::vector<ManoeuvreFigure> FiguresOf(const Manoeuvre& manoeuvre, const ManoeuvreTrack& track);

// What a figure may be at most for a ship of this length [m] at this speed [m/s], by IMO
// MSC.137(76): of a turning circle at 35 degrees, and of the zigzags 10/10 and 20/20. Nothing of
// other figures and manoeuvres.
std::optional<double> ImoLimit(const Manoeuvre& manoeuvre,
                               std::string_view figure,
                               double length,
                               double ahead);

}  // namespace fathom
