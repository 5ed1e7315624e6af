// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/effects/catalogue.h"

#include "fathom/vehicle/effect_of.h"
#include "fathom/vehicle/effects/coupling.h"
#include "fathom/vehicle/effects/drag.h"
#include "fathom/vehicle/effects/forces.h"
#include "fathom/vehicle/effects/pose_sensor.h"
#include "fathom/vehicle/effects/thrust_curve.h"
#include "fathom/vehicle/effects/thrust_in_time.h"
#include "fathom/vehicle/effects/velocity_sensor.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <ceres/jet.h>

namespace fathom {
namespace {

// A line for each effect, in the order in which they act.
const std::vector<Effect>& Effects() {
  static const std::vector<Effect> effects = {
      // Actuator: between the command and the force that acts.
      EffectOf<TimeOffset>(),
      EffectOf<ThrustDeadZone>(),
      EffectOf<ThrustSaturation>(),
      EffectOf<ThrustCurve>(),
      EffectOf<ThrustAsymmetry>(),
      EffectOf<ThrustFade>(),
      EffectOf<ThrustStepLoss>(),
      EffectOf<ThrustSlewLimit>(),
      EffectOf<ThrusterLag>(),
      EffectOf<ThrustInflowLoss>(),
      // Water: between the force and the motion.
      EffectOf<DampingAsymmetry>(),
      EffectOf<CubicDamping>(),
      EffectOf<CoulombFriction>(),
      EffectOf<SteadyCurrent>(),
      EffectOf<PositionStiffness>(),
      EffectOf<RightingMoment>(),
      EffectOf<BuoyancyStep>(),
      EffectOf<BuoyancyDrift>(),
      EffectOf<PeriodicForce>(),
      EffectOf<FluidMemory>(),
      EffectOf<CoriolisCoupling>(),
      EffectOf<VelocityCoupling>(),
      EffectOf<ThrustCrosstalk>(),
      // Sensor: between the motion and what is measured of it.
      EffectOf<SensorMisalignment>(),
      EffectOf<LeverArm>(),
      EffectOf<SensorBias>(),
      EffectOf<SensorLag>(),
      EffectOf<SensorClockOffset>(),
      EffectOf<PoseScale>(),
      EffectOf<MarkerMoved>(),
  };
  return effects;
}

// Where an effect acts: its place, then its turn in the catalogue.
std::pair<Place, std::ptrdiff_t> TurnOf(const Effect* effect) {
  const auto catalogue = EffectCatalogue();
  const auto found = std::find(catalogue.begin(), catalogue.end(), effect);
  return {effect->info().place, found - catalogue.begin()};
}

}  // namespace

std::span<const Effect* const> EffectCatalogue() {
  static const std::vector<const Effect*> catalogue = [] {
    std::vector<const Effect*> pointers;
    for (const Effect& effect : Effects()) pointers.push_back(&effect);
    return pointers;
  }();
  return catalogue;
}

const Effect* FindEffect(std::string_view name) {
  const auto catalogue = EffectCatalogue();
  const auto found = std::find_if(catalogue.begin(), catalogue.end(), [&](const Effect* effect) {
    return effect->info().name == name;
  });
  return found == catalogue.end() ? nullptr : *found;
}

bool ActsBefore(const Effect* a, const Effect* b) { return TurnOf(a) < TurnOf(b); }

}  // namespace fathom
