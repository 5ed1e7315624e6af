// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled_planning/coupled_plan.h"
#include "fathom/simulate/coupled/coupled_data.h"

namespace fathom {

// A boat of surge, sway and yaw, drawn, and what a first log of a minute told of it. `colour`: how
// noise of neighbouring samples correlates.
struct DrawnBoat {
  CoupledModel truth;
  FittedCoupledModel fitted;
};
DrawnBoat DrawBoat(unsigned seed, double colour = 0.0);

// 40 N, 40 N and 8 N m; 0.8 m/s, 0.6 m/s and 0.8 rad/s; 8 m each way.
CoupledPlanRequest BoatRequest(const DrawnBoat& boat, double duration, double effort);

inline constexpr double kBoatNoise = 0.01;  // of the velocities [m/s] or [rad/s]

// What the truth does under a command at 10 Hz, by another simulator than Fathom's, with noise
// of this standard deviation and colour.
CoupledData PlayedLog(const CoupledModel& truth,
                      const CoupledCommand& command,
                      double duration,
                      double noise,
                      unsigned seed,
                      double colour = 0.0);

}  // namespace fathom
