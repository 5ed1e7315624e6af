// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/simulate/coupled/coupled_simulation.h"
#include "fathom/vehicle/fitted_model.h"

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <string>

namespace fathom {

// What an experiment of several DOFs may do; docs/file_formats.md, "Limits of several DOFs".
struct CoupledLimits {
  static constexpr double kNoLimit = std::numeric_limits<double>::infinity();
  static constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();

  // By Index(Dof), greatest each way.
  std::array<double, 6> force = {};  // [N] or [N m]; 0: not commanded
  std::array<double, 6> speed = {kNoLimit, kNoLimit, kNoLimit, kNoLimit, kNoLimit, kNoLimit};

  // From the start, along the axes that the body has there: ahead, starboard, down [m].
  std::array<ValueRange, 3> room = {ValueRange{-kNoLimit, kNoLimit},
                                    ValueRange{-kNoLimit, kNoLimit},
                                    ValueRange{-kNoLimit, kNoLimit}};
  double tilt = kNoLimit;               // greatest angle to the upright [rad]
  double heading = kNoLimit;            // greatest turn from that at the start, either way [rad]
  double thruster_force = kNoLimit;     // greatest of each thruster, either way [N]
  double shortest_hold = 1.0;           // of one force: the period of the command [s]
  std::optional<double> duration = {};  // [s]

  // How velocities will be measured. NaN: as in the model's log.
  double rate = kNotKnown;  // [Hz]
  std::array<double, 6> noise = {
      kNotKnown, kNotKnown, kNotKnown, kNotKnown, kNotKnown, kNotKnown};  // white [m/s] or [rad/s]
};

// True if all states of a run from the origin stay within the limits.
bool KeepsLimits(std::span<const CoupledState> run, const CoupledLimits& limits);

// From a limits file (YAML). Throws InputError, naming file, line and key, for whatever breaks the
// format. `name` stands for the file in messages.
CoupledLimits ParseCoupledLimits(const std::string& name, const std::string& text);

}  // namespace fathom
