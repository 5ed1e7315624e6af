// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/command_forces.h"

#include "fathom/simulate/coupled/asked_force.h"
#include "fathom/vehicle/coupled/turned_about_z.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace fathom {
namespace {

using Kind = FreeEntry::Kind;

double ValueOr(double otherwise,
               const std::map<std::string, double>& values,
               const std::string& name) {
  const auto found = values.find(name);
  return found == values.end() ? otherwise : found->second;
}

// The row of a command that holds at a time; none before the first.
std::optional<std::size_t> RowAt(const CoupledCommand& command, double t) {
  const auto next = std::upper_bound(command.time.begin(), command.time.end(), t);
  if (next == command.time.begin()) return std::nullopt;
  return static_cast<std::size_t>(next - command.time.begin()) - 1;
}

// How late wrench and thrusters are [s].
double LatenessOfThrust(const CoupledModel& model) {
  return model.time_offset + model.thruster_lag;
}

// The impulse of wrench and thrusters, or its derivative by an entry.
Vector6 ImpulseOf(const CoupledCommand& command,
                  double from,
                  double to,
                  const CoupledModel& model,
                  const FreeEntry* by) {
  const auto force = [&](std::size_t row) {
    return by == nullptr ? AskedForce(command, row, model) : AskedForceBy(*by, command, row, model);
  };
  from -= LatenessOfThrust(model);
  to -= LatenessOfThrust(model);
  Vector6 sum = Vector6::Zero();
  const std::vector<double>& time = command.time;
  auto next =
      static_cast<std::size_t>(std::upper_bound(time.begin(), time.end(), from) - time.begin());
  for (double t = from; t < to;) {
    const double until = next < time.size() ? std::min(time[next], to) : to;
    if (next > 0) sum += (until - t) * force(next - 1);
    t = until;
    ++next;
  }
  return sum;
}

Vector6 ThrustAtTime(const CoupledCommand& command, double t, const CoupledModel& model) {
  const auto row = RowAt(command, t - LatenessOfThrust(model));
  return row ? AskedForce(command, *row, model) : Vector6::Zero();
}

double FinForceIn(const CoupledModel& model, const CommandedFin& fin) {
  return ValueOr(0.0, model.fin_force, fin.name);
}

// Of a fin by its place in the command.
FinLoad LoadOf(const CoupledCommand& command,
               const FinAngles& angles,
               std::size_t place,
               double t,
               const Vector6& nu,
               const CoupledModel& model) {
  const CommandedFin& fin = command.fins[place];
  t = t - model.time_offset - ValueOr(0.0, model.fin_lag, fin.name);
  const auto at = RowAt(command, t);
  if (!at) return {};
  const auto stuck = model.fin_stuck.find(fin.name);
  const double angle = stuck != model.fin_stuck.end()
                           ? stuck->second
                           : angles.At(place, *at, t - command.time[*at]) -
                                 ValueOr(0.0, model.fin_neutral, fin.name);
  const double race = ValueOr(0.0, model.fin_race, fin.name);
  const double stall = ValueOr(std::numeric_limits<double>::infinity(), model.fin_stall, fin.name);
  return FinLoadAt(fin.arms, nu, angle, race * RaceThrust(command, fin, *at, nu), stall);
}

Vector6 ForceOf(const CoupledCommand& command,
                const FinAngles& angles,
                std::size_t place,
                double t,
                const Vector6& nu,
                const CoupledModel& model) {
  const double size = FinForceIn(model, command.fins[place]);
  if (size == 0.0) return Vector6::Zero();
  return size * LoadOf(command, angles, place, t, nu, model).Force();
}

// The fin that an entry is of; none where it is of no fin of the command.
std::optional<std::size_t> FinOf(const FreeEntry& entry, const CoupledCommand& command) {
  const auto fin = std::ranges::find(command.fins, entry.actuator, &CommandedFin::name);
  if (fin == command.fins.end()) return std::nullopt;
  return static_cast<std::size_t>(fin - command.fins.begin());
}

}  // namespace

Vector6 ThrustImpulse(const CoupledCommand& command,
                      double from,
                      double to,
                      const CoupledModel& model) {
  return ImpulseOf(command, from, to, model, nullptr);
}

Vector6 ThrustImpulseBy(const FreeEntry& entry,
                        const CoupledCommand& command,
                        double from,
                        double to,
                        const CoupledModel& model) {
  switch (entry.kind) {
    case Kind::kThrustGain:
    case Kind::kEffect:
    case Kind::kThrusterEffect:
      return ImpulseOf(command, from, to, model, &entry);
    case Kind::kThrustAngle:
      return ByTurnAboutZ(ThrustImpulse(command, from, to, model));
    case Kind::kThrusterLag:
    case Kind::kTimeOffset:
      return ThrustAtTime(command, from, model) - ThrustAtTime(command, to, model);
    default:
      return Vector6::Zero();
  }
}

Vector6 ShaftForcesAt(const CoupledCommand& command,
                      double t,
                      const Vector6& nu,
                      const CoupledModel& model) {
  if (command.shafts.empty()) return Vector6::Zero();
  const auto row = RowAt(command, t - model.time_offset);
  return row ? ShaftForces(command, *row, nu, model) : Vector6::Zero();
}

Vector6 ShaftForcesBy(const FreeEntry& entry,
                      const CoupledCommand& command,
                      double t,
                      const Vector6& nu,
                      const CoupledModel& model) {
  if (entry.kind != Kind::kThrustGain || command.shafts.empty()) return Vector6::Zero();
  const auto row = RowAt(command, t - model.time_offset);
  return row ? ShaftForces(command, *row, nu, model, &entry.actuator) : Vector6::Zero();
}

Vector6 FinForcesAt(const CoupledCommand& command,
                    const FinAngles& angles,
                    double t,
                    const Vector6& nu,
                    const CoupledModel& model) {
  Vector6 force = Vector6::Zero();
  for (std::size_t k = 0; k < command.fins.size(); ++k) {
    force += ForceOf(command, angles, k, t, nu, model);
  }
  return force;
}

Vector6 FinForcesBy(const FreeEntry& entry,
                    const CoupledCommand& command,
                    const FinAngles& angles,
                    double t,
                    const Vector6& nu,
                    const CoupledModel& model) {
  const auto place = FinOf(entry, command);
  if (!place) return Vector6::Zero();
  const CommandedFin& fin = command.fins[*place];
  const FinLoad load = LoadOf(command, angles, *place, t, nu, model);
  switch (entry.kind) {
    case Kind::kFinForce:
      return load.Force();
    case Kind::kFinNeutral:
      return -FinForceIn(model, fin) * load.ForceByAngle();
    case Kind::kFinStuck:
      return FinForceIn(model, fin) * load.ForceByAngle();
    default:
      return Vector6::Zero();
  }
}

Vector6 FinForcesLater(const FreeEntry& entry,
                       const CoupledCommand& command,
                       const FinAngles& angles,
                       double t,
                       const Vector6& nu,
                       const CoupledModel& model) {
  if (entry.kind == Kind::kTimeOffset) return FinForcesAt(command, angles, t, nu, model);
  const auto fin = FinOf(entry, command);
  if (entry.kind != Kind::kFinLag || !fin) return Vector6::Zero();
  return ForceOf(command, angles, *fin, t, nu, model);
}

}  // namespace fathom
