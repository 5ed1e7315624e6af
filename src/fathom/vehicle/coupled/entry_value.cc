// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/coupled/entry_value.h"

#include "fathom/vehicle/coupled/coupled_effects.h"

#include <limits>
#include <string>

namespace fathom {
namespace {

using EntryKind = FreeEntry::Kind;

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

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
      return &model->fin_rate_limit.try_emplace(entry.actuator, kNoLimit).first->second;
    case EntryKind::kFinStall:
      return &model->fin_stall.try_emplace(entry.actuator, kNoLimit).first->second;
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
    case EntryKind::kRunOffset:
      return &model->run_offset.try_emplace(entry.actuator, Vector6::Zero())
                  .first->second[Index(entry.row)];
  }
  return nullptr;
}

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
  for (const auto& [log, offset] : model.run_offset) {
    for (const Dof row : kAllDofs) add(RunOffsetEntry(row, log), 0.0);
  }
  for (const auto& [fin, rate] : model.fin_rate_limit) add(FinRateLimitEntry(fin), kNoLimit);
  for (const auto& [fin, angle] : model.fin_stall) add(FinStallEntry(fin), kNoLimit);
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
