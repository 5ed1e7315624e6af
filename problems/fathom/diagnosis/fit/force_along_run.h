// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/data/measured_segments.h"
#include "fathom/vehicle/extended_model.h"

#include <span>
#include <vector>

namespace fathom {

// One instant of the run of one segment.
struct RunPoint {
  double time;      // log time [s]
  double velocity;  // simulated [m/s] or [rad/s]
  double position;  // simulated [m] or [rad]
  double command;   // [N] or [N m]
  int segment;      // index
};

// Whether an effect is a force that depends on nothing but the instant.
bool IsForceInWater(const Effect& effect);

// Such an effect's force at every point of a run of `baseline` [N] or [N m], along its motion
// positive; 0 in logs that the effect does not act in.
std::vector<double> ForceAlong(std::span<const RunPoint> points,
                               std::span<const MeasuredSegment> segments,
                               const UncoupledModel<double>& baseline,
                               const ActiveEffect& active);

}  // namespace fathom
