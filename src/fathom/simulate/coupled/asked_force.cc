// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/coupled/asked_force.h"

#include "fathom/vehicle/coupled/coupled_effects.h"
#include "fathom/vehicle/coupled/turned_about_z.h"

#include <string>

namespace fathom {
namespace {

using Kind = FreeEntry::Kind;

double GainOf(const CommandedThruster& thruster, const CoupledModel& model) {
  const auto gain = model.thrust_gain.find(thruster.name);
  return gain == model.thrust_gain.end() ? 1.0 : gain->second;
}

// The numbers of ThrustEffects() of the wrench along a DOF.
ThrustEffectValues ValuesAlong(Eigen::Index dof, const CoupledModel& model) {
  ThrustEffectValues values = {};
  for (std::size_t k = 0; k < values.size(); ++k) {
    const auto found = model.effects.find(std::string(ThrustEffects()[k]->info().name));
    if (found != model.effects.end()) values[k] = found->second[dof];
  }
  return values;
}

// Of every thruster.
ThrustEffectValues ValuesOfThrusters(const CoupledModel& model) {
  ThrustEffectValues values = {};
  for (std::size_t k = 0; k < values.size(); ++k) {
    const auto found = model.thruster_effects.find(std::string(ThrustEffects()[k]->info().name));
    if (found != model.thruster_effects.end()) values[k] = found->second;
  }
  return values;
}

// An effect's place among ThrustEffects().
std::size_t PlaceOf(const Effect& effect) {
  std::size_t k = 0;
  while (ThrustEffects()[k] != &effect) ++k;
  return k;
}

double ThrustOf(const CommandedThruster& thruster, std::size_t row, const CoupledModel& model) {
  if (model.thruster_effects.empty()) return thruster.thrust[row];
  return ThrustWith(ValuesOfThrusters(model), thruster.thrust[row]).force;
}

}  // namespace

Vector6 AskedForce(const CoupledCommand& command, std::size_t row, const CoupledModel& model) {
  Vector6 force = Vector6::Zero();
  if (!command.force.empty()) force = command.force[row];
  if (!command.force.empty() && !model.effects.empty()) {
    for (Eigen::Index i = 0; i < 6; ++i) {
      force[i] = ThrustWith(ValuesAlong(i, model), force[i]).force;
    }
  }
  for (const CommandedThruster& thruster : command.thrusters) {
    force += GainOf(thruster, model) * (ThrustOf(thruster, row, model) * thruster.push);
  }
  return TurnedAboutZ(model.thrust_angle, force);
}

Vector6 AskedForceBy(const FreeEntry& entry,
                     const CoupledCommand& command,
                     std::size_t row,
                     const CoupledModel& model) {
  Vector6 by = Vector6::Zero();
  if (entry.kind == Kind::kThrustGain) {
    for (const CommandedThruster& thruster : command.thrusters) {
      if (thruster.name == entry.actuator) by += ThrustOf(thruster, row, model) * thruster.push;
    }
  } else if (entry.kind == Kind::kThrusterEffect) {
    const ThrustEffectValues values = ValuesOfThrusters(model);
    const std::size_t place = PlaceOf(*entry.effect);
    for (const CommandedThruster& thruster : command.thrusters) {
      by += GainOf(thruster, model) * ThrustWith(values, thruster.thrust[row]).by_value[place] *
            thruster.push;
    }
  } else if (entry.kind == Kind::kEffect && IsOfThrust(*entry.effect) && !command.force.empty()) {
    const Eigen::Index i = Index(entry.row);
    by[i] =
        ThrustWith(ValuesAlong(i, model), command.force[row][i]).by_value[PlaceOf(*entry.effect)];
  }
  return TurnedAboutZ(model.thrust_angle, by);
}

}  // namespace fathom
