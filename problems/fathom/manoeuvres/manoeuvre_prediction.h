// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/log.h"
#include "fathom/manoeuvres/measured_gear.h"
#include "fathom/manoeuvres/steering_table.h"
#include "fathom/report/table.h"
#include "fathom/simulate/coupled/manoeuvre.h"
#include "fathom/simulate/coupled/manoeuvre_figures.h"
#include "fathom/simulate/coupled/manoeuvre_run.h"
#include "fathom/vehicle/coupled/fitted_coupled_model.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace fathom {

struct ManoeuvreDraws {
  int count = 200;         // of models, at least 0
  std::uint64_t seed = 1;  // the same seed, the same models
};

// A figure of a manoeuvre, with the interval that the model's intervals give.
struct PredictedFigure {
  ManoeuvreFigure figure;
  double low = 0.0, high = 0.0;         // 95 %; NaN where too few draws came so far
  std::optional<double> limit = {};     // ImoLimit(), of a vehicle whose length is known
  std::optional<double> measured = {};  // of a log that holds this manoeuvre and came so far
};

struct ManoeuvrePrediction {
  Manoeuvre manoeuvre;
  ManoeuvreTrack track;
  std::vector<PredictedFigure> figures;
  std::vector<ManoeuvreTrack> drawn =
      {};  // of models that came through; none of spiral and pull-out
  std::optional<ManoeuvreTrack> measured = {};  // MeasuredManoeuvre()
  std::optional<MeasuredGear> gear = {};        // GearOf() the log
  int num_draws = 0, num_astray = 0;  // models drawn, and those of them that cannot be or diverge
  double ahead = 0.0;                 // speed at the begin [m/s]
  double rudder_rate = 0.0;           // [rad/s]; infinite: at once
  double rudder_delay = 0.0;          // [s]
  double logged_angle = 0.0;          // largest of the rudder in the log [rad]
  std::optional<double> length = {};  // of the vehicle [m]
  // What a spiral or a pull-out says of the straight track; why figures have no value; doubts.
  std::vector<std::string> sentences = {};
};

// What a model does in a manoeuvre that begins at the log's first speed ahead, under its mean force
// and with the rudder as quick, and in a zigzag as late, as in the log. The interval is of models
// drawn from the covariance. `rudder_delay` [s] in place of the log's; at least 0.
//
// Throws InputError if the log holds no fin that turns the vehicle, or the model moves no yaw, and
// if the run itself diverges. Of a stop: if the model moves no surge, or nothing drives it ahead.
ManoeuvrePrediction PredictManoeuvre(const FittedCoupledModel& fitted,
                                     const Log& log,
                                     const Manoeuvre& manoeuvre,
                                     const ManoeuvreDraws& draws,
                                     std::optional<double> rudder_delay = {});

// The derivatives of SteeringOf() at the log's first speed ahead, under its mean force, and
// NomotoOf() them, with intervals as above. `track` is empty.
//
// Throws InputError if the log holds no fin that turns the vehicle, or the model moves no yaw; and
// of kPrime if the vehicle file tells no size.
ManoeuvrePrediction PredictSteering(const FittedCoupledModel& fitted,
                                    const Log& log,
                                    SteeringUnits units,
                                    const ManoeuvreDraws& draws);

// A row for each figure: value, interval, and where any is known what the log measured and the
// limit.
Table ManoeuvreTable(const ManoeuvrePrediction& report);

// How the rudder moves, and whence that is known, in a sentence; empty of a stop and of steering.
std::string GearSentence(const ManoeuvrePrediction& report);

// Why figures have no interval, in a sentence; empty where all have one, or no model was drawn.
std::string NoIntervalSentence(const ManoeuvrePrediction& report);

// That the rudder turns further than it does in the log, in a sentence; empty where it does not.
std::string BeyondTheLogSentence(const ManoeuvrePrediction& report);

// t, position, heading, rudder's angle as the fin counts it and velocities, CSV.
std::string ManoeuvreCsv(const ManoeuvrePrediction& report);

}  // namespace fathom
