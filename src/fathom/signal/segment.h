// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/held_command.h"

#include <limits>
#include <vector>

namespace fathom {

// One DOF over one unbroken stretch of a log. The vectors over `time` have its length.
struct Segment {
  std::vector<double> time;      // stamps of the motion stream [s], strictly increasing
  std::vector<double> velocity;  // as measured, or derived from the poses [m/s] or [rad/s]
  // Displacement along the DOF [m] or [rad]. Empty without poses, and where the DOF's axis turns in
  // the world: no displacement along it then tells the speed.
  std::vector<double> position;
  HeldCommand command;  // at its own stamps

  // Velocity at the first stamp, by a local polynomial over the samples behind it, so that the
  // noise of one sample does not colour a whole free run. NaN if there are too few [m/s] or
  // [rad/s].
  double initial_velocity = std::numeric_limits<double>::quiet_NaN();

  // For the equation-error families (least squares): both sides of docs/models.md (2) through the
  // same Savitzky-Golay derivative filter, so that neither lags or is smoothed more than the other:
  // derivatives of the velocity, of the displacement, of the integral of v|v| and of the command's
  // impulse (docs/signal.md (3)). NaN near an end of the data, where the filter's window is
  // one-sided and its noise several times larger.
  std::vector<double> acceleration;       // [m/s^2] or [rad/s^2]
  std::vector<double> smoothed_velocity;  // [m/s] or [rad/s]
  std::vector<double> smoothed_force;     // [N] or [N m]
  std::vector<double> smoothed_square;    // v|v| [m^2/s^2]; empty: that of smoothed_velocity
};

}  // namespace fathom
