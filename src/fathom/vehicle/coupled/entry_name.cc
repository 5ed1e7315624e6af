// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/coupled/entry_name.h"

#include "fathom/base/input_error.h"
#include "fathom/base/quoted.h"
#include "fathom/vehicle/coupled/coupled_effects.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

using EntryKind = FreeEntry::Kind;

struct NamedKind {
  EntryKind kind;
  std::string_view name;
};

constexpr std::array<NamedKind, 18> kNamedKinds = {{
    {EntryKind::kInertia, "inertia"},
    {EntryKind::kLinearDamping, "linear_damping"},
    {EntryKind::kQuadraticDamping, "quadratic_damping"},
    {EntryKind::kRightingMoment, "righting_moment"},
    {EntryKind::kNetBuoyancy, "net_buoyancy"},
    {EntryKind::kOffset, "offset"},
    {EntryKind::kThrustGain, "thrust_gain"},
    {EntryKind::kThrustAngle, "thrust_angle"},
    {EntryKind::kTimeOffset, "time_offset"},
    {EntryKind::kThrusterLag, "thruster_lag"},
    {EntryKind::kLift, "lift"},
    {EntryKind::kFinForce, "fin_force"},
    {EntryKind::kFinRace, "fin_race"},
    {EntryKind::kFinNeutral, "fin_neutral"},
    {EntryKind::kFinStuck, "fin_stuck"},
    {EntryKind::kFinLag, "fin_lag"},
    {EntryKind::kFinRateLimit, "fin_rate_limit"},
    {EntryKind::kFinStall, "fin_stall"},
}};

std::string_view NameOfKind(EntryKind kind) {
  return kNamedKinds[static_cast<std::size_t>(kind)].name;
}

// An effect that a coupled model may hold; null if there is none of this name.
const Effect* EffectOfName(std::string_view name) {
  for (const auto effects : {WaterEffects(), ThrustEffects()}) {
    for (const Effect* effect : effects) {
      if (effect->info().name == name) return effect;
    }
  }
  return nullptr;
}

// Whether there is one of a model, with a name of its own.
bool IsOneOfModel(EntryKind kind) {
  return kind == EntryKind::kThrusterEffect || kind == EntryKind::kNetBuoyancy ||
         kind == EntryKind::kThrustAngle || kind == EntryKind::kTimeOffset ||
         kind == EntryKind::kThrusterLag;
}

bool HasPair(EntryKind kind) {
  return kind == EntryKind::kInertia || kind == EntryKind::kLinearDamping ||
         kind == EntryKind::kQuadraticDamping || kind == EntryKind::kLift;
}

bool CanRight(Dof dof) { return dof == Dof::kRoll || dof == Dof::kPitch; }

[[noreturn]] void RefuseEntry(std::string_view name, std::string_view expected) {
  throw InputError(
      fmt::format("{} is no entry of a coupled model, expected {}.", Quoted(name), expected));
}

// An effect of every thruster has no tail.
FreeEntry ParseEffect(std::string_view name, const Effect& effect, std::string_view tail) {
  if (IsOfThrust(effect) && name == effect.info().name) return ThrusterEffectEntry(effect);
  const std::optional<Dof> row = DofFromName(tail);
  if (!row) {
    RefuseEntry(name,
                fmt::format("{}. and one of the DOFs{}",
                            effect.info().name,
                            IsOfThrust(effect)
                                ? fmt::format(", or {} alone of the thrusters", effect.info().name)
                                : ""));
  }
  return EffectEntry(effect, *row);
}

// "north.dive_3" of a current.
FreeEntry ParseCurrent(std::string_view name, std::string_view tail) {
  for (const auto& [axis, dof] : {std::pair{std::string_view("north."), Dof::kSurge},
                                  std::pair{std::string_view("east."), Dof::kSway}}) {
    if (tail.starts_with(axis) && tail.size() > axis.size()) {
      return CurrentEntry(dof, std::string(tail.substr(axis.size())));
    }
  }
  RefuseEntry(name, "current.north. or current.east. and the name of a log");
}

// Powers of metre and second in the unit of a force over those of `column`, times kg.
std::string UnitOfMetres(int metres, int seconds) {
  std::string unit = metres >= 0 ? "kg" : "kg/m";
  if (metres > 0) unit += metres == 1 ? " m" : " m^2";
  return seconds == 0 ? unit : unit + "/s";
}

std::string SiUnitOf(const FreeEntry& entry) {
  const int row = IsAngular(entry.row) ? 1 : 0, column = IsAngular(entry.column) ? 1 : 0;
  switch (entry.kind) {
    case EntryKind::kInertia:
      return UnitOfMetres(row + column, 0);
    case EntryKind::kLinearDamping:
      return UnitOfMetres(row + column, 1);
    case EntryKind::kQuadraticDamping:
      return UnitOfMetres(row + 2 * column - 1, 0);
    case EntryKind::kRightingMoment:
    case EntryKind::kOffset:
    case EntryKind::kRunOffset:
      return std::string(ForceUnit(entry.row));
    case EntryKind::kNetBuoyancy:
      return "N";
    case EntryKind::kThrustGain:
      return "1";
    case EntryKind::kLift:
      return UnitOfMetres(row + column - 1, 0);
    case EntryKind::kFinForce:
      return "kg/m";
    case EntryKind::kFinRace:
      return "m^2/(s^2 N)";
    case EntryKind::kThrustAngle:
    case EntryKind::kFinNeutral:
    case EntryKind::kFinStuck:
    case EntryKind::kFinStall:
      return "rad";
    case EntryKind::kTimeOffset:
    case EntryKind::kThrusterLag:
    case EntryKind::kFinLag:
      return "s";
    case EntryKind::kCurrent:
      return "m/s";
    case EntryKind::kFinRateLimit:
      return "rad/s";
    case EntryKind::kEffect:
    case EntryKind::kThrusterEffect:
      break;  // UnitOf() below
  }
  return "";
}

}  // namespace

std::string NameOf(const FreeEntry& entry) {
  if (entry.kind == EntryKind::kCurrent) {
    const bool is_north = entry.row == Dof::kSurge;
    return fmt::format("current.{}.{}", is_north ? "north" : "east", entry.actuator);
  }
  if (entry.kind == EntryKind::kRunOffset) {
    return fmt::format("offset.{}.{}", Name(entry.row), entry.actuator);
  }
  const std::string_view kind =
      IsEffect(entry) ? entry.effect->info().name : NameOfKind(entry.kind);
  if (IsOneOfModel(entry.kind)) return std::string(kind);
  if (IsOfActuator(entry)) return fmt::format("{}.{}", kind, entry.actuator);
  if (entry.row == entry.column) return fmt::format("{}.{}", kind, Name(entry.row));
  return fmt::format("{}.{}.{}", kind, Name(entry.row), Name(entry.column));
}

FreeEntry ParseFreeEntry(std::string_view name) {
  const std::size_t dot = name.find('.');
  const std::string_view head = name.substr(0, dot);
  const bool has_tail = dot != std::string_view::npos;
  const std::string_view tail = has_tail ? name.substr(dot + 1) : std::string_view();
  if (head == "current") return ParseCurrent(name, tail);
  if (const Effect* effect = EffectOfName(head)) return ParseEffect(name, *effect, tail);
  const auto found = std::find_if(
      kNamedKinds.begin(), kNamedKinds.end(), [&](const NamedKind& k) { return k.name == head; });
  if (found == kNamedKinds.end()) {
    RefuseEntry(name,
                "inertia, linear_damping, quadratic_damping, righting_moment, net_buoyancy, "
                "offset, thrust_gain, thrust_angle, time_offset, thruster_lag, lift, fin_force, "
                "fin_race, fin_neutral, fin_stuck, fin_lag, fin_rate_limit, fin_stall, "
                "damping_asymmetry, cubic_damping, coulomb_friction, thrust_dead_zone, "
                "thrust_asymmetry or current, a dot, and what it belongs to");
  }
  const EntryKind kind = found->kind;
  if (IsOneOfModel(kind)) {
    if (has_tail) RefuseEntry(name, fmt::format("{} alone", head));
    if (kind == EntryKind::kThrustAngle) return ThrustAngleEntry();
    return {kind};
  }
  if (IsOfActuator({kind})) {
    if (tail.empty()) {
      RefuseEntry(name, fmt::format("{}. and the name of a thruster or a fin", head));
    }
    return {kind, Dof::kSurge, Dof::kSurge, std::string(tail)};
  }
  const std::size_t second_dot = tail.find('.');
  const bool is_pair = second_dot != std::string_view::npos;
  const std::optional<Dof> row = DofFromName(tail.substr(0, second_dot));
  if (kind == EntryKind::kOffset && row && is_pair && second_dot + 1 < tail.size()) {
    return RunOffsetEntry(*row, std::string(tail.substr(second_dot + 1)));
  }
  const std::optional<Dof> column = is_pair ? DofFromName(tail.substr(second_dot + 1)) : row;
  if (!row || !column || (is_pair && (!HasPair(kind) || row == column))) {
    RefuseEntry(name,
                HasPair(kind) ? fmt::format("{}. and one of surge, sway, heave, roll, pitch, yaw, "
                                            "or two different ones with a dot between",
                                            head)
                              : fmt::format("{}. and one of the DOFs", head));
  }
  if (kind == EntryKind::kRightingMoment && !CanRight(*row)) {
    RefuseEntry(name, "righting_moment.roll or righting_moment.pitch");
  }
  if (kind == EntryKind::kInertia) return InertiaEntry(*row, *column);
  return {kind, *row, *column};
}

std::string UnitOf(const FreeEntry& entry, const std::string& force_unit) {
  if (IsEffect(entry)) {
    const Quantity& quantity = entry.effect->info().parameters.front().quantity;
    return UnitOf(
        quantity, entry.row, force_unit == "N" ? std::string(ForceUnit(entry.row)) : force_unit);
  }
  const std::string unit = SiUnitOf(entry);
  const bool has_force = unit != "1" && unit != "rad" && unit != "s" && unit != "rad/s" &&
                         unit != "m/s" && entry.kind != EntryKind::kFinRace;
  if (force_unit == "N" || !has_force) return unit;
  return fmt::format("{} {}/N", unit, force_unit);
}

}  // namespace fathom
