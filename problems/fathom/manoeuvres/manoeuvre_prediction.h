// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/log.h"
#include "fathom/report/table.h"
#include "fathom/simulate/coupled/manoeuvre.h"
#include "fathom/vehicle/coupled/fitted_coupled_model.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// A figure of a manoeuvre, with the interval that the model's intervals give.
struct PredictedFigure {
  ManoeuvreFigure figure;
  double low = 0.0, high = 0.0;      // 95 %; NaN where too few draws came so far
  std::optional<double> limit = {};  // ImoLimit(), of a vehicle whose length is known
};

struct ManoeuvrePrediction {
  ManoeuvreTrack track;
  std::vector<PredictedFigure> figures;
  int num_draws = 0, num_astray = 0;  // models drawn, and those of them that cannot be or diverge
  double ahead = 0.0;                 // speed at the begin [m/s]
  double rudder_rate = 0.0;           // [rad/s]
};

// What a model does in a manoeuvre that begins at the log's first speed ahead, under its mean force
// and with the rudder as quick as it ever is in the log. The interval is of models drawn from the
// covariance.
//
// Throws InputError if the log holds no fin that turns the vehicle, or the model moves no yaw, and
// if the run itself diverges.
ManoeuvrePrediction PredictManoeuvre(const FittedCoupledModel& fitted,
                                     const Log& log,
                                     const Manoeuvre& manoeuvre,
                                     int num_draws,
                                     std::uint64_t seed);

// How the tables of naval architects count.
enum class SteeringUnits {
  kSi,
  kPrime,  // by rho/2 of fresh water, the vehicle's length and the speed
};

// "si", "prime". Throws InputError, with what is expected, for anything else.
SteeringUnits ParseSteeringUnits(std::string_view text);

// The derivatives of SteeringOf() at the log's first speed ahead, under its mean force, and
// NomotoOf() them, with intervals as above. `track` is empty.
//
// Throws InputError if the log holds no fin that turns the vehicle, or the model moves no yaw; and
// of kPrime if the vehicle file tells no size.
ManoeuvrePrediction PredictSteering(const FittedCoupledModel& fitted,
                                    const Log& log,
                                    SteeringUnits units,
                                    int num_draws,
                                    std::uint64_t seed);

Table ManoeuvreTable(const ManoeuvrePrediction& report);

// t, position, heading, rudder's angle and velocities, CSV.
std::string ManoeuvreCsv(const ManoeuvrePrediction& report);

}  // namespace fathom
