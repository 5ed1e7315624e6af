// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/synthesize/experiment/experiment.h"
#include "fathom/synthesize/motion/vehicle_motion.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace fathom {

// What is commanded at each stamp, and the states at all times at which a held force changes.
struct TrueRun {
  std::vector<double> command_time;            // stamps since the start [s]
  std::vector<std::array<double, 6>> command;  // by Index(Dof) [N] or [N m]

  std::vector<double> time;  // since the start [s], strictly increasing, the first 0
  std::vector<MotionState> states;
  std::vector<HeldForces> held;  // from there on

  // Place in `time` of the last one at or before t; counts up from `from`.
  std::size_t Before(double t, std::size_t from = 0) const;

  MotionState StateAt(const VehicleMotion& motion, std::size_t place, double t) const;
};

// Until when commands are stamped [s]: the end of the experiment, or later where a command acts
// before its stamp (`time_offset` below 0), since its clock is ahead.
double LastCommand(const VehicleMotion& motion, const Experiment& experiment);

// Drives the vehicle through the experiment. Where a command acts before its stamp, the
// controller reads the position when it acts.
TrueRun DriveThrough(const VehicleMotion& motion, const Experiment& experiment, std::uint64_t seed);

}  // namespace fathom
