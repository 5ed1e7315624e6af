// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/simulate/coupled/manoeuvre.h"
#include "fathom/simulate/coupled/manoeuvre_run.h"

#include <limits>
#include <string>
#include <vector>

namespace fathom {

// A number by which a manoeuvre is judged; NaN where the run did not come so far.
struct ManoeuvreFigure {
  std::string name;  // "tactical_diameter"
  double value = std::numeric_limits<double>::quiet_NaN();
  std::string unit;  // "m"
};

// Of a turning circle advance, transfer, tactical diameter, steady radius and speed, transfer and
// diameter to the side of the turn; of a zigzag the first two overshoot angles [deg] and the
// period; of a stop track reach, head reach, lateral deviation (to starboard) and time; of a spiral
// the loop's width [deg of the rudder] and the yaw rates [deg/s] at midships, after a turn to
// either side, and at the largest angle; of a pull-out those at the angle and at midships behind
// it.
std::vector<ManoeuvreFigure> FiguresOf(const Manoeuvre& manoeuvre, const ManoeuvreTrack& track);

}  // namespace fathom
