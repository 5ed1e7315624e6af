// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/coupled/coupled_inputs.h"

#include <algorithm>

#include <Eigen/Geometry>

namespace fathom {
namespace {

bool NamesAThruster(const CoupledCommand& command, const std::string& name) {
  return std::ranges::find(command.thrusters, name, &CommandedThruster::name) !=
         command.thrusters.end();
}

bool NamesAShaft(const CoupledCommand& command, const std::string& name) {
  return std::ranges::any_of(command.shafts,
                             [&](const CommandedShaft& one) { return one.shaft.name == name; });
}

}  // namespace

CommandedShaft CommandedShaftOf(const Shaft& shaft) {
  CommandedShaft commanded = {shaft};
  commanded.push << Eigen::Vector3d::UnitX(), shaft.position.cross(Eigen::Vector3d::UnitX());
  return commanded;
}

ShaftThrust ThrustOnVehicle(const CommandedShaft& shaft, double turns, const Vector6& nu) {
  ShaftThrust at = ShaftThrustAt(shaft.shaft, turns, shaft.push.dot(nu));
  const double kept = 1.0 - shaft.shaft.thrust_deduction.value_or(0.0);
  at.thrust *= kept;
  at.by_speed *= kept;
  return at;
}

double RaceThrust(const CoupledCommand& command, const CommandedFin& fin, std::size_t row) {
  if (fin.behind.empty() || NamesAShaft(command, fin.behind)) return 0.0;
  double of_it = 0.0, of_all = command.force.empty() ? 0.0 : command.force[row][0];
  bool is_named = false;
  for (const CommandedThruster& thruster : command.thrusters) {
    const double ahead = thruster.push[0] * thruster.thrust[row];
    of_all += ahead;
    if (thruster.name != fin.behind) continue;
    is_named = true;
    of_it = ahead;
  }
  return std::max(is_named ? of_it : of_all, 0.0);
}

std::vector<std::size_t> RaceShafts(const CoupledCommand& command, const CommandedFin& fin) {
  std::vector<std::size_t> shafts;
  if (fin.behind.empty()) return shafts;
  const bool is_of_all = !NamesAShaft(command, fin.behind) && !NamesAThruster(command, fin.behind);
  for (std::size_t k = 0; k < command.shafts.size(); ++k) {
    if (is_of_all || command.shafts[k].shaft.name == fin.behind) shafts.push_back(k);
  }
  return shafts;
}

double RaceThrust(const CoupledCommand& command,
                  const CommandedFin& fin,
                  std::size_t row,
                  const Vector6& nu) {
  double race = RaceThrust(command, fin, row);
  for (const std::size_t k : RaceShafts(command, fin)) {
    const CommandedShaft& shaft = command.shafts[k];
    race += ShaftThrustAt(shaft.shaft, shaft.turns[row], shaft.push.dot(nu)).thrust;
  }
  return std::max(race, 0.0);
}

Vector6 ShaftForces(const CoupledCommand& command,
                    std::size_t row,
                    const Vector6& nu,
                    const CoupledModel& model,
                    const std::string* only) {
  Vector6 force = Vector6::Zero();
  for (const CommandedShaft& shaft : command.shafts) {
    if (only != nullptr && *only != shaft.shaft.name) continue;
    const auto found = model.thrust_gain.find(shaft.shaft.name);
    const double gain = only != nullptr || found == model.thrust_gain.end() ? 1.0 : found->second;
    force += gain * ThrustOnVehicle(shaft, shaft.turns[row], nu).thrust * shaft.push;
  }
  return force;
}

}  // namespace fathom
