// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/effect_info.h"
#include "fathom/vehicle/effect_law.h"
#include "fathom/vehicle/effects/bounds.h"
#include "fathom/vehicle/effects/natural_units.h"
#include "fathom/vehicle/effects/quantities.h"

// What another DOF does to this one. Equations: docs/effects.md.
namespace fathom {

// Turning about z couples surge and sway, and the way made damps the turn. Along yaw the yaw rate
// is the vehicle's own, EffectStack sees to that.
struct CoriolisCoupling {
  static EffectInfo Info() {
    return {
        .name = "coriolis_coupling",
        .place = Place::kWater,
        .scope = Scope::kVehicle,
        .parameters = {{.name = "coefficient",
                        .quantity = kMass,
                        .null = 0.0,
                        .lower = -kInfinity,
                        .upper = kInfinity,
                        .drawn = {0.1, 0.8, natural::Coriolis, true}}},
        .partner = PartnerInfo{.rule = IsInThePlane, .velocity = true, .yaw_rate = true},
        .cause = "turning while moving: a Coriolis force, or damping of the turn by the way made",
        .advice = "Use a model of coupled DOFs, or identify without turning."};
  }
  static bool IsInThePlane(Dof dof, Dof partner) {
    const bool may_turn = Index(dof) <= Index(Dof::kSway) || dof == Dof::kYaw;
    return may_turn && Index(partner) <= Index(Dof::kSway);
  }
  template <typename T>
  static EffectLaw<T> Law() {
    return {.resistance = [](const T* p, const WaterState<T>&, const Instant<T>& now) {
      return p[0] * now.partner.velocity * now.partner.yaw_rate;
    }};
  }
};

struct VelocityCoupling {
  static EffectInfo Info() {
    return {.name = "velocity_coupling",
            .place = Place::kWater,
            .scope = Scope::kVehicle,
            .parameters = {{.name = "coefficient",
                            .quantity = kLinearDrag,
                            .null = 0.0,
                            .lower = -kInfinity,
                            .upper = kInfinity,
                            .drawn = {0.05, 0.6, natural::Coupling, true}}},
            .partner = PartnerInfo{.velocity = true},
            .cause = "damping coupled to the motion of another DOF",
            .advice = "Add the damping between the two DOFs to the model."};
  }
  template <typename T>
  static EffectLaw<T> Law() {
    return {.resistance = [](const T* p, const WaterState<T>&, const Instant<T>& now) {
      return p[0] * now.partner.velocity;
    }};
  }
};

struct ThrustCrosstalk {
  static EffectInfo Info() {
    return {.name = "thrust_crosstalk",
            .place = Place::kWater,
            .scope = Scope::kVehicle,
            .parameters = {{.name = "gain",
                            .quantity = kRatio,
                            .null = 0.0,
                            .lower = -kInfinity,
                            .upper = kInfinity,
                            .drawn = {0.05, 0.6, natural::Crosstalk, true}}},
            .partner = PartnerInfo{.force = true},
            .cause = "thrust that was commanded for another DOF",
            .advice = "Check the thrusters' directions and the allocation."};
  }
  template <typename T>
  static EffectLaw<T> Law() {
    return {.resistance = [](const T* p, const WaterState<T>&, const Instant<T>& now) {
      return -p[0] * now.partner.force;
    }};
  }
};

}  // namespace fathom
