// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/coupled/free_entry.h"

#include "fathom/vehicle/coupled/coupled_effects.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <limits>
#include <numbers>

namespace fathom {
namespace {

using EntryKind = FreeEntry::Kind;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

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
FreeEntry RunOffsetEntry(Dof row, const std::string& log) {
  return {EntryKind::kRunOffset, row, row, log};
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

bool IsOfRun(const FreeEntry& entry) {
  return entry.kind == EntryKind::kCurrent || entry.kind == EntryKind::kRunOffset;
}

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

}  // namespace fathom
