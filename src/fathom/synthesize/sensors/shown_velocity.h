// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/synthesize/motion/true_run.h"
#include "fathom/synthesize/motion/vehicle_motion.h"

#include <array>
#include <cstddef>
#include <vector>

namespace fathom {

// What a velocity sensor would show without noise, asked at times that increase, from 0 on. A
// sensor that lags follows the truth in steps of at most 5 ms; it starts at the first reading.
class ShownVelocity {
 public:
  // Both must outlive this.
  ShownVelocity(const VehicleMotion& motion, const TrueRun& run);

  // By Index(Dof) [m/s] or [rad/s].
  std::array<double, 6> At(double t);

 private:
  using Readings = std::array<double, 6>;
  Readings ReadingsOf(const MotionState& state, const HeldForces& held, double t) const;
  void Follow(const Readings& readings, double t);

  const VehicleMotion& motion_;
  const TrueRun& run_;
  // By Index(Dof): what turns the readings of two DOFs, and the rest.
  std::array<HiddenEffects, 6> turning_;
  std::array<HiddenEffects, 6> others_;
  std::vector<Dof> following_;  // where the sensor lags
  std::size_t place_ = 0;       // in run_
  double time_ = 0.0;
  Readings last_;  // readings at time_, before any lag
  Readings shown_;
};

}  // namespace fathom
