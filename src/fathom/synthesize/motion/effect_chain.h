// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/vehicle/extended_model.h"

#include <array>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// The truth about all DOFs at one instant, from which an effect takes what it asks of its partner.
struct Surroundings {
  double time = 0.0;                            // since the first command sample [s]
  const Eigen::Matrix<double, 6, 1>& velocity;  // true [m/s] or [rad/s], by Index(Dof)
  const std::array<double, 6>& command;         // as logged at this time [N] or [N m]
};

// Everything that is hidden in one DOF, in the order in which it acts: docs/synthesize.md (10).
// Other code than EffectSimulation, over the same laws: each can test the other.
class EffectChain {
 public:
  // Of `effects`, those of `dof`; effects of one place that are not in EffectCatalogue() come after
  // those that are.
  EffectChain() = default;
  EffectChain(Dof dof, std::span<const ActiveEffect> effects);

  bool empty() const { return effects_.empty(); }
  const std::vector<ActiveEffect>& effects() const { return effects_; }

  // Actuator. f(t) = tau(t - Delay()) [s].
  double Delay() const;
  // Mean force over the `duration` in which `command` is held; moves `states` on, of which there is
  // one for each effect.
  double MeanForce(double command, const Surroundings& now, double duration, double* states) const;
  double ForceAtSpeed(double force, double speed) const;

  // Water. Speed through the water.
  double RelativeSpeed(double speed) const;
  // Left-hand side [N] or [N m]; `memories` as `states` above. water.memory is filled in.
  double Resistance(WaterState<double> water,
                    const Surroundings& now,
                    const double* memories) const;
  void MemoryRates(const double* memories, double speed, double* rates) const;

  // Sensor. What the pose shows of a displacement at a true time.
  double Displacement(double displacement, const Surroundings& now) const;

 private:
  std::vector<ActiveEffect> effects_;
};

// What an effect is told of its surroundings.
Instant<double> InstantOf(const ActiveEffect& effect, const Surroundings& now);

}  // namespace fathom
