// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/planning/plan_request.h"

#include <span>

namespace fathom {

// Of the paper's Table I [rad/s].
inline constexpr double kSineFrequency = 0.3;

// The experiment that people drive otherwise: a sine about the force that holds the vehicle.
struct OrdinarySine {
  double amplitude = 0.0;  // [N] or [N m]
  double offset = 0.0;
  HeldCommand command;
};

// The greatest that the model's own run keeps the limits under, in steps of a twentieth.
OrdinarySine LargestOrdinarySine(const PlanRequest& request,
                                 double duration,
                                 std::span<const double> stamps);

// What stands for the log that a verdict is about, of which its file tells the greatest force
// alone: the sine of that force, or of the limits' where it tells none.
HeldCommand SineOfLog(const PlanRequest& request, double duration);

}  // namespace fathom
