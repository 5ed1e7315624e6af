// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/motion/effect_chain.h"

#include "fathom/vehicle/effects/catalogue.h"

#include <algorithm>
#include <cstddef>

#include <glog/logging.h>

namespace fathom {
namespace {

const EffectLaw<double>& LawOf(const ActiveEffect& active) {
  return active.effect->laws().In<double>();
}

const EffectHooks& Has(const ActiveEffect& active) { return active.effect->laws().has; }

// Place in the catalogue, or behind all of it.
std::ptrdiff_t PlaceInCatalogue(const ActiveEffect& active) {
  const auto catalogue = EffectCatalogue();
  return std::find(catalogue.begin(), catalogue.end(), active.effect) - catalogue.begin();
}

}  // namespace

Instant<double> InstantOf(const ActiveEffect& active, const Surroundings& now) {
  const int partner = Index(active.setting.partner);
  return {now.time, {now.velocity[partner], now.velocity[Index(Dof::kYaw)], now.command[partner]}};
}

EffectChain::EffectChain(Dof dof, std::span<const ActiveEffect> effects) {
  for (const ActiveEffect& active : effects) {
    if (active.setting.dof != dof) continue;
    CHECK(active.effect != nullptr);
    CHECK_EQ(active.values.size(), active.effect->info().parameters.size())
        << active.effect->info().name;
    effects_.push_back(active);
  }
  std::stable_sort(effects_.begin(), effects_.end(), [](const auto& a, const auto& b) {
    return PlaceInCatalogue(a) < PlaceInCatalogue(b);
  });
}

double EffectChain::Delay() const {
  double delay = 0.0;
  for (const ActiveEffect& active : effects_) {
    if (Has(active).delay) delay += LawOf(active).Delay(active.values.data());
  }
  return delay;
}

double EffectChain::MeanForce(double command,
                              const Surroundings& now,
                              double duration,
                              double* states) const {
  double force = command;
  for (const ActiveEffect& active : effects_) {
    const double* p = active.values.data();
    if (Has(active).thrust) {
      force = LawOf(active).Thrust(p, active.setting, force, InstantOf(active, now));
    }
    if (Has(active).follow) force = LawOf(active).Follow(p, force, duration, states);
    ++states;
  }
  return force;
}

double EffectChain::ForceAtSpeed(double force, double speed) const {
  for (const ActiveEffect& active : effects_) {
    if (!Has(active).thrust_at_speed) continue;
    force = LawOf(active).ThrustAtSpeed(active.values.data(), force, speed);
  }
  return force;
}

double EffectChain::RelativeSpeed(double speed) const {
  for (const ActiveEffect& active : effects_) {
    if (!Has(active).relative_speed) continue;
    speed = LawOf(active).RelativeSpeed(active.values.data(), speed);
  }
  return speed;
}

double EffectChain::Resistance(WaterState<double> water,
                               const Surroundings& now,
                               const double* memories) const {
  double resistance = 0.0;
  for (const ActiveEffect& active : effects_) {
    water.memory = *memories++;
    if (!Has(active).resistance) continue;
    resistance += LawOf(active).Resistance(
        active.values.data(), active.setting, water, InstantOf(active, now));
  }
  return resistance;
}

void EffectChain::MemoryRates(const double* memories, double speed, double* rates) const {
  for (const ActiveEffect& active : effects_) {
    *rates = Has(active).memory_rate
                 ? LawOf(active).MemoryRate(active.values.data(), *memories, speed)
                 : 0.0;
    ++memories;
    ++rates;
  }
}

double EffectChain::Displacement(double displacement, const Surroundings& now) const {
  for (const ActiveEffect& active : effects_) {
    if (!Has(active).displacement) continue;
    displacement =
        LawOf(active).Displacement(active.values.data(), displacement, InstantOf(active, now));
  }
  return displacement;
}

}  // namespace fathom
