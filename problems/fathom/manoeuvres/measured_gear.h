// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/simulate/coupled/manoeuvre_run.h"

#include <limits>
#include <optional>

namespace fathom {

// How quick a log's rudder turns from one side to the other, and of a zigzag how late.
//
// A stroke is taken for a ramp: at the slope between 60 % of the angle on either side, through its
// zero. It begins where that ramp does, so that a slow start and a slow end of the gear count as a
// later one. The delay leads from the heading's reaching the order to this begin. All are medians.
struct MeasuredGear {
  int num_strokes = 0;
  double angle = 0.0;                                     // that the rudder goes to [rad]
  double rate = std::numeric_limits<double>::infinity();  // [rad/s]; infinite: within a sample

  // Of a zigzag, else NaN. The order is not logged: it is the largest of 1, 2, 3, 5, 7.5, 10, 15
  // ... degrees that the heading has passed at the begin of every stroke.
  double heading = std::numeric_limits<double>::quiet_NaN();  // the order [rad]
  double course = std::numeric_limits<double>::quiet_NaN();   // about which it counts [rad]
  double delay = std::numeric_limits<double>::quiet_NaN();    // [s]
  double least_delay = std::numeric_limits<double>::quiet_NaN();
  double most_delay = std::numeric_limits<double>::quiet_NaN();

  bool IsZigzag() const { return delay >= 0.0; }
};

// Nothing if the rudder never goes from one side to the other. `logged`: LoggedTrack().
std::optional<MeasuredGear> GearOf(const ManoeuvreTrack& logged);

}  // namespace fathom
