// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/signal/segment.h"
#include "fathom/simulate/effect_inputs.h"
#include "fathom/simulate/simulate.h"
#include "fathom/vehicle/extended_model.h"

#include <optional>
#include <span>

namespace fathom {

// What was measured of one unbroken stretch of motion. Velocities or displacements may be empty,
// not both.
struct MeasuredMotion {
  double start = 0.0;                     // where a run begins, not behind the first stamp [s]
  std::span<const double> velocity_time;  // [s]
  std::span<const double> velocity;       // [m/s] or [rad/s]
  std::span<const double> displacement_time;
  std::span<const double> displacement;  // [m] or [rad]
};

// Of a segment: its positions, where it has any, since its velocities then are derived from them;
// else its velocities.
MeasuredMotion MotionOf(const Segment& segment);

// Where every free run starts: at the state from which the model's run fits the first two seconds
// of what was measured (ten samples at least) best, in least squares: the speed, the place where it
// is measured, and what a sensor with a memory shows. Samples far from the others count for
// nothing. What is measured is not the state, and a straight line through it is none where the
// motion turns within these seconds. Where velocities are measured, they alone tell the speed.
//
// `position`: the place where no displacement is measured [m] or [rad]. Nothing if the run
// diverges.
std::optional<InitialState> FittedStart(const ExtendedModel& model,
                                        const EffectInputs& inputs,
                                        const MeasuredMotion& motion,
                                        double position = 0.0);

}  // namespace fathom
