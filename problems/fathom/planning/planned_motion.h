// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/log/held_command.h"
#include "fathom/vehicle/extended_model.h"

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// What a model does under a command, from rest.
struct PlannedMotion {
  std::vector<double> velocity;      // [m/s] or [rad/s], as the sensor shows it
  std::vector<double> displacement;  // from the start [m] or [rad]
};

// Its derivatives, a row for each stamp.
struct MotionDerivatives {
  // Of the velocity.
  Eigen::MatrixXd by_parameter;  // in the order of FittedModel::covariance
  Eigen::MatrixXd by_start;      // by what a fit leaves free of the start: speed, and excesses

  // Of the displacement; a fit to poses leaves the position at the start free too, last column.
  Eigen::MatrixXd displacement_by_parameter;
  Eigen::MatrixXd displacement_by_start;
};

// Behind the command the vehicle coasts until somebody takes over; the limits hold so long [s].
inline constexpr double kCoastAfterwards = 10.0;

// Stamps from `period` on to `duration` [s].
std::vector<double> PlannedStamps(double duration, double period);

// Stamps up to `duration` [s] at which motion is held against limits, `coarsest` [s] apart at most.
// Where the command may change there is one: speed has its peaks there. Holds shorter than that
// are looked at every few.
std::vector<double> LimitStamps(double hold, double duration, double coarsest);

// From t = 0 to the stamps, by the simulations that fits use: docs/models.md (5), (6). The command
// begins at t = 0. Nothing if the run diverges. No effect may need a partner.
std::optional<PlannedMotion> MotionUnder(const ExtendedModel& model,
                                         Dof dof,
                                         const HeldCommand& command,
                                         std::span<const double> stamps,
                                         MotionDerivatives* derivatives = nullptr);

}  // namespace fathom
