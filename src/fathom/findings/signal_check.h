// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/findings/finding.h"
#include "fathom/signal/signals.h"

#include <span>
#include <string>
#include <vector>

namespace fathom {

// What is odd about the data before any fit; docs/findings.md. Cheap.
//
//   passivity           warning  force and velocity, about their means, give a mean power below
//                                zero; a note where it is far above zero with the means
//   force_sign          warning  force and acceleration oppose each other at equal velocity
//   speed_range         warning  speeds over 20 m/s; a note for turns over 20 rad/s
//   pulse_widths        warning  the force is a pulse width of 800 to 2200 us (pulse_widths.h)
//   constant_command    warning  the force never changes
//   constant_velocity   warning  the velocity never changes
//   sampling_rate       warning  median step below 1 ms or above 1 s
//   jitter, gap         note     steps of the stamps that are far from the median
std::vector<Finding> CheckSignals(std::span<const Segment> segments,
                                  Dof dof,
                                  const std::string& force_unit);

// The same for what is to be trained on.
inline std::vector<Finding> CheckSignals(const Signals& signals) {
  return CheckSignals(signals.train, signals.dof, signals.force_unit);
}

}  // namespace fathom
