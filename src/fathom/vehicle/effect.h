// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"

#include <string>
#include <string_view>
#include <vector>

namespace fathom {

template <typename T>
class EffectLaw;
struct EffectLaws;

// An effect is a mechanism that the baseline model (docs/models.md (1)) leaves out: a slow
// propeller, a tether, a turned sensor. It acts in one of three places; docs/effects.md lists them.
enum class Place { kActuator, kWater, kSensor };

// What a parameter belongs to: the vehicle (holds in every log) or the run (holds in one log).
enum class Scope { kVehicle, kRun };

// "actuator", "water" or "sensor".
std::string_view Name(Place place);

// A kind of number: its unit in words, and how large such a number naturally is on a given log, as
// powers of the force that was commanded (RMS), the speed reached (RMS) and one second.
struct Quantity {
  std::string_view linear_unit;   // of surge, sway and heave: "N/m"
  std::string_view angular_unit;  // of roll, pitch and yaw: "N m/rad"
  double force = 0.0;
  double speed = 0.0;
  double time = 0.0;
};

// How a parameter's value is looked for before it is refined.
enum class Search {
  kAmount,          // the response is about proportional to it: one small probe tells
  kSize,            // an amount whose response changes shape with its size: tried at several sizes
  kTimeOfRun,       // a time within the log: tried all along it
  kFrequencyOfRun,  // a frequency that the log can show: tried from its slowest to its fastest
  kShape            // a time constant that means nothing without an amount: tried at `trials`
};

// One number of an effect.
struct EffectParameter {
  std::string_view name;  // canonical, as in verdict files: "time_constant"
  Quantity quantity;
  double null;   // where the model is exactly the baseline; may be infinite. NaN: at any value, as
                 // long as the other parameters are at theirs
  double lower;  // bounds of a physical value
  double upper;
  Search search = Search::kAmount;
  // In natural sizes of the quantity: where to look (kSize, kShape), how far to probe (kAmount; a
  // fiftieth where empty).
  std::vector<double> trials = {};
};

// What people and files need to know about an effect.
struct EffectInfo {
  std::string_view name;  // canonical: "thruster_lag"
  Place place;
  Scope scope;
  std::vector<EffectParameter> parameters;

  // Another DOF that takes part: its measured velocity or its command is an input of the effect.
  bool has_partner = false;

  // True where the displacement itself must be measured, beside the velocity, for the effect to
  // leave any trace.
  bool needs_pose = false;

  std::string_view cause;   // what it is, after "because": "the propellers take time to spin up"
  std::string_view advice;  // what to do about it, a sentence
};

// An effect of the catalogue, or a user's own: EffectOf<Struct> (effect_of.h) makes one from a
// struct that states its equation once, for plain and differentiated scalars.
// docs/adding_an_effect.md.
class Effect {
 public:
  virtual ~Effect() = default;
  virtual const EffectInfo& info() const = 0;

  // The equation, for every scalar a simulation runs in.
  virtual const EffectLaws& laws() const = 0;
};

// Unit of a parameter of an effect along `dof`, where forces are given in `force_unit` ("N", "N m"
// or a log's own): "N/m".
std::string UnitOf(const Quantity& quantity, Dof dof, const std::string& force_unit);

}  // namespace fathom
