// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/log.h"
#include "fathom/simulate/coupled/coupled_data.h"
#include "fathom/vehicle/coupled/coupled_model.h"

#include <random>

namespace fathom {

// A small vehicle in the plane, drawn: a diagonal model with C(nu).
CoupledModel DrawnPlanarVehicle(std::mt19937* random);

struct DrawnLogOptions {
  double duration = 200.0;  // [s]
  double rate = 10.0;       // [Hz]
  double noise = 0.01;      // standard deviation of the velocities [m/s]; of rates the same [rad/s]
  double colour = 0.8;      // correlation of neighbouring samples
  Eigen::Vector3d current = Eigen::Vector3d::Zero();         // world [m/s]
  Vector6 force = Vector6(25.0, 30.0, 25.0, 2.0, 2.0, 8.0);  // of the steps
};

// What its velocity sensor shows while it is driven by random steps of 2 to 6 s, simulated by
// another integrator than Fathom's; noise of first order.
CoupledData DrawnLog(const CoupledModel& model,
                     const DrawnLogOptions& options,
                     std::mt19937* random);

// What a log file would hold of drawn data.
Log LogFileOf(const CoupledData& data);

}  // namespace fathom
