// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/vehicle/effect_parameter.h"

#include <optional>
#include <string_view>
#include <vector>

namespace fathom {

// An effect is a mechanism that the baseline model (docs/models.md (1)) leaves out: a slow
// propeller, a tether, a turned sensor. It acts in one of three places; docs/effects.md lists them.
enum class Place { kActuator, kWater, kSensor };

// What a parameter belongs to: the vehicle (holds in every log) or the run (holds in one log).
enum class Scope { kVehicle, kRun };

// "actuator", "water" or "sensor".
std::string_view Name(Place place);

// Another DOF that takes part in an effect.
struct PartnerInfo {
  // Which it may be, of those that are another DOF than the effect's own. Null: any.
  bool (*rule)(Dof dof, Dof partner) = nullptr;

  // What the effect reads of it: its measured velocity, the measured yaw rate beside, its command.
  bool velocity = false;
  bool yaw_rate = false;
  bool force = false;
};

// Effects that are easily mistaken for one another have a confusion in common, the same object.
struct Confusion {
  std::string_view experiment;  // that tells them apart, a sentence
  bool decides = true;          // false: no experiment of this kind can, and the sentence says so
};

// What people and files need to know about an effect.
struct EffectInfo {
  std::string_view name;  // canonical: "thruster_lag"
  Place place;
  Scope scope;
  std::vector<EffectParameter> parameters;

  // True where its force depends on when, not only on what the vehicle does.
  bool depends_on_time = false;

  std::optional<PartnerInfo> partner = {};

  // Which DOFs it can act along. Null: any.
  bool (*acts_along)(Dof dof) = nullptr;

  // True where its equation needs the displacement as measured, not from the start of a segment.
  bool needs_displacement = false;

  // True where the displacement itself must be measured, beside the velocity, for the effect to
  // leave any trace.
  bool needs_pose = false;

  // True where poses that lose motion of themselves show the same.
  bool is_like_lost_motion = false;

  // True where EffectSetting::reference_force is part of the equation.
  bool uses_reference_force = false;

  std::string_view cause;   // what a sentence says after "comes from": "a lag of the thrusters"
  std::string_view advice;  // what to do about it, a sentence

  // With other effects; in the order in which a text is to name their experiments.
  std::vector<const Confusion*> confusions = {};

  bool has_partner() const { return partner.has_value(); }
};

// Whether the effect can act along `dof`. As below, one rule for what is hidden, looked for and
// read.
bool CanActAlong(const EffectInfo& info, Dof dof);

// Whether `partner` can take part in the effect along `dof`; false where nothing takes part. The
// one rule for what is hidden and for what is looked for.
bool CanBePartner(const EffectInfo& info, Dof dof, Dof partner);

}  // namespace fathom
