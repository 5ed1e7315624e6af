// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/coupled/free_entry.h"

#include "fathom/base/input_error.h"
#include "fathom/base/quoted.h"
#include "fathom/vehicle/coupled/coupled_effects.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

using EntryKind = FreeEntry::Kind;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

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

// Powers of metre and second in the unit of a force over those of `column`, times kg.
std::string UnitOfMetres(int metres, int seconds) {
  std::string unit = metres >= 0 ? "kg" : "kg/m";
  if (metres > 0) unit += metres == 1 ? " m" : " m^2";
  return seconds == 0 ? unit : unit + "/s";
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

double* PlaceIn(CoupledModel* model, const FreeEntry& entry) {
  switch (entry.kind) {
    case EntryKind::kInertia:
      return &model->inertia(Index(entry.row), Index(entry.column));
    case EntryKind::kLinearDamping:
      return &model->linear_damping(Index(entry.row), Index(entry.column));
    case EntryKind::kQuadraticDamping:
      return &model->quadratic_damping(Index(entry.row), Index(entry.column));
    case EntryKind::kRightingMoment:
      return entry.row == Dof::kRoll ? &model->righting_roll : &model->righting_pitch;
    case EntryKind::kNetBuoyancy:
      return &model->net_buoyancy;
    case EntryKind::kOffset:
      return &model->offset[Index(entry.row)];
    case EntryKind::kThrustGain:
      return &model->thrust_gain.try_emplace(entry.actuator, 1.0).first->second;
    case EntryKind::kThrustAngle:
      return &model->thrust_angle;
    case EntryKind::kTimeOffset:
      return &model->time_offset;
    case EntryKind::kThrusterLag:
      return &model->thruster_lag;
    case EntryKind::kLift:
      return &model->lift(Index(entry.row), Index(entry.column));
    case EntryKind::kFinForce:
      return &model->fin_force.try_emplace(entry.actuator, 0.0).first->second;
    case EntryKind::kFinRace:
      return &model->fin_race.try_emplace(entry.actuator, 0.0).first->second;
    case EntryKind::kFinNeutral:
      return &model->fin_neutral.try_emplace(entry.actuator, 0.0).first->second;
    case EntryKind::kFinStuck:
      return &model->fin_stuck.try_emplace(entry.actuator, 0.0).first->second;
    case EntryKind::kFinLag:
      return &model->fin_lag.try_emplace(entry.actuator, 0.0).first->second;
    case EntryKind::kFinRateLimit:
      return &model->fin_rate_limit.try_emplace(entry.actuator, kInfinite).first->second;
    case EntryKind::kFinStall:
      return &model->fin_stall.try_emplace(entry.actuator, kInfinite).first->second;
    case EntryKind::kEffect: {
      const std::string name(entry.effect->info().name);
      return &model->effects.try_emplace(name, Vector6::Zero()).first->second[Index(entry.row)];
    }
    case EntryKind::kThrusterEffect: {
      const std::string name(entry.effect->info().name);
      return &model->thruster_effects.try_emplace(name, 0.0).first->second;
    }
    case EntryKind::kCurrent:
      return &model->current.try_emplace(entry.actuator, Eigen::Vector2d::Zero())
                  .first->second[Index(entry.row)];
  }
  return nullptr;
}

}  // namespace

FreeEntry InertiaEntry(Dof a, Dof b) {
  return {EntryKind::kInertia, std::min(a, b), std::max(a, b)};
}
FreeEntry LinearDampingEntry(Dof row, Dof column) {
  return {EntryKind::kLinearDamping, row, column};
}
FreeEntry QuadraticDampingEntry(Dof row, Dof column) {
  return {EntryKind::kQuadraticDamping, row, column};
}
FreeEntry OffsetEntry(Dof row) { return {EntryKind::kOffset, row, row}; }
FreeEntry RightingMomentEntry(Dof row) { return {EntryKind::kRightingMoment, row, row}; }
FreeEntry NetBuoyancyEntry() { return {EntryKind::kNetBuoyancy}; }
FreeEntry ThrustGainEntry(const std::string& thruster) {
  return {EntryKind::kThrustGain, Dof::kSurge, Dof::kSurge, thruster};
}
FreeEntry ThrustAngleEntry() { return {EntryKind::kThrustAngle, Dof::kSway, Dof::kSurge}; }
FreeEntry TimeOffsetEntry() { return {EntryKind::kTimeOffset}; }
FreeEntry ThrusterLagEntry() { return {EntryKind::kThrusterLag}; }
FreeEntry LiftEntry(Dof row, Dof column) { return {EntryKind::kLift, row, column}; }
FreeEntry FinForceEntry(const std::string& fin) {
  return {EntryKind::kFinForce, Dof::kSurge, Dof::kSurge, fin};
}
FreeEntry FinRaceEntry(const std::string& fin) {
  return {EntryKind::kFinRace, Dof::kSurge, Dof::kSurge, fin};
}
FreeEntry FinNeutralEntry(const std::string& fin) {
  return {EntryKind::kFinNeutral, Dof::kSurge, Dof::kSurge, fin};
}
FreeEntry FinStuckEntry(const std::string& fin) {
  return {EntryKind::kFinStuck, Dof::kSurge, Dof::kSurge, fin};
}
FreeEntry FinLagEntry(const std::string& fin) {
  return {EntryKind::kFinLag, Dof::kSurge, Dof::kSurge, fin};
}
FreeEntry CurrentEntry(Dof axis, const std::string& log) {
  return {EntryKind::kCurrent, axis, axis, log};
}
FreeEntry FinRateLimitEntry(const std::string& fin) {
  return {EntryKind::kFinRateLimit, Dof::kSurge, Dof::kSurge, fin};
}
FreeEntry FinStallEntry(const std::string& fin) {
  return {EntryKind::kFinStall, Dof::kSurge, Dof::kSurge, fin};
}
FreeEntry EffectEntry(const Effect& effect, Dof row) {
  return {EntryKind::kEffect, row, row, {}, &effect};
}
FreeEntry ThrusterEffectEntry(const Effect& effect) {
  return {EntryKind::kThrusterEffect, Dof::kSurge, Dof::kSurge, {}, &effect};
}

bool IsOfActuator(const FreeEntry& entry) {
  return entry.kind == EntryKind::kThrustGain || entry.kind == EntryKind::kFinForce ||
         entry.kind == EntryKind::kFinRace || entry.kind == EntryKind::kFinNeutral ||
         entry.kind == EntryKind::kFinStuck || entry.kind == EntryKind::kFinLag ||
         entry.kind == EntryKind::kFinRateLimit || entry.kind == EntryKind::kFinStall ||
         entry.kind == EntryKind::kTimeOffset || entry.kind == EntryKind::kThrusterLag ||
         entry.kind == EntryKind::kThrusterEffect || IsOfRun(entry);
}

bool IsOfRun(const FreeEntry& entry) { return entry.kind == EntryKind::kCurrent; }

bool IsLag(const FreeEntry& entry) {
  return entry.kind == EntryKind::kThrusterLag || entry.kind == EntryKind::kFinLag;
}

bool IsLimit(const FreeEntry& entry) {
  return entry.kind == EntryKind::kFinRateLimit || entry.kind == EntryKind::kFinStall;
}

bool IsEffect(const FreeEntry& entry) { return entry.effect != nullptr; }

bool IsPositive(const FreeEntry& entry) {
  return IsLag(entry) || IsLimit(entry) ||
         (IsEffect(entry) && entry.effect->info().parameters.front().lower == 0.0);
}

double LowerBoundOf(const FreeEntry& entry) {
  const bool is_of_body = entry.kind == EntryKind::kInertia ||
                          entry.kind == EntryKind::kLinearDamping ||
                          entry.kind == EntryKind::kQuadraticDamping;
  if ((is_of_body && entry.row == entry.column) || IsPositive(entry)) return 0.0;
  if (IsEffect(entry)) return entry.effect->info().parameters.front().lower;
  return -kInfinite;
}

bool MayBe(const FreeEntry& entry, double value) {
  if (entry.kind == EntryKind::kFinStall) return value > 0.0 && value < 0.5 * std::numbers::pi;
  if (IsLimit(entry)) return value > 0.0;
  if (!IsEffect(entry)) return true;
  const EffectParameter& parameter = entry.effect->info().parameters.front();
  return value >= parameter.lower && value <= parameter.upper;
}

bool IsLateness(const FreeEntry& entry) {
  return IsLag(entry) || entry.kind == EntryKind::kTimeOffset;
}

int ParameterOf(const FreeEntry& entry) {
  if (entry.row != entry.column) return -1;
  switch (entry.kind) {
    case EntryKind::kInertia:
      return kInertia;
    case EntryKind::kQuadraticDamping:
      return kQuadraticDamping;
    case EntryKind::kLinearDamping:
      return kLinearDamping;
    case EntryKind::kOffset:
    case EntryKind::kNetBuoyancy:
      return kBuoyancy;
    default:
      return -1;
  }
}

std::string NameOf(const FreeEntry& entry) {
  if (entry.kind == EntryKind::kCurrent) {
    const bool is_north = entry.row == Dof::kSurge;
    return fmt::format("current.{}.{}", is_north ? "north" : "east", entry.actuator);
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

namespace {

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

namespace {

// Every entry that a model of all six DOFs could have, but for those of thrusters and fins.
std::vector<FreeEntry> AllEntries() {
  std::vector<FreeEntry> all;
  for (const Dof row : kAllDofs) {
    for (const Dof column : kAllDofs) {
      if (row <= column) all.push_back(InertiaEntry(row, column));
      all.push_back(LinearDampingEntry(row, column));
      all.push_back(QuadraticDampingEntry(row, column));
      all.push_back(LiftEntry(row, column));
    }
    all.push_back(OffsetEntry(row));
    for (const auto effects : {WaterEffects(), ThrustEffects()}) {
      for (const Effect* effect : effects) all.push_back(EffectEntry(*effect, row));
    }
  }
  for (const Effect* effect : ThrustEffects()) all.push_back(ThrusterEffectEntry(*effect));
  all.push_back(RightingMomentEntry(Dof::kRoll));
  all.push_back(RightingMomentEntry(Dof::kPitch));
  all.push_back(NetBuoyancyEntry());
  all.push_back(ThrustAngleEntry());
  all.push_back(TimeOffsetEntry());
  all.push_back(ThrusterLagEntry());
  return all;
}

}  // namespace

std::vector<FreeEntry> EntriesIn(const CoupledModel& model) {
  std::vector<FreeEntry> entries;
  const auto add = [&](const FreeEntry& entry, double without) {
    if (ValueIn(model, entry) != without) entries.push_back(entry);
  };
  for (const FreeEntry& entry : AllEntries()) add(entry, 0.0);
  for (const auto& [thruster, gain] : model.thrust_gain) add(ThrustGainEntry(thruster), 1.0);
  for (const auto& [fin, force] : model.fin_force) add(FinForceEntry(fin), 0.0);
  for (const auto& [fin, race] : model.fin_race) add(FinRaceEntry(fin), 0.0);
  for (const auto& [fin, neutral] : model.fin_neutral) add(FinNeutralEntry(fin), 0.0);
  for (const auto& [fin, angle] : model.fin_stuck) entries.push_back(FinStuckEntry(fin));
  for (const auto& [fin, lag] : model.fin_lag) add(FinLagEntry(fin), 0.0);
  for (const auto& [log, current] : model.current) {
    for (const Dof axis : {Dof::kSurge, Dof::kSway}) add(CurrentEntry(axis, log), 0.0);
  }
  for (const auto& [fin, rate] : model.fin_rate_limit) add(FinRateLimitEntry(fin), kInfinite);
  for (const auto& [fin, angle] : model.fin_stall) add(FinStallEntry(fin), kInfinite);
  return entries;
}

double ValueIn(const CoupledModel& model, const FreeEntry& entry) {
  CoupledModel copy = model;
  return *PlaceIn(&copy, entry);
}

void SetValue(const FreeEntry& entry, double value, CoupledModel* model) {
  *PlaceIn(model, entry) = value;
  if (entry.kind == EntryKind::kInertia) {
    model->inertia(Index(entry.column), Index(entry.row)) = value;
  }
}

}  // namespace fathom
