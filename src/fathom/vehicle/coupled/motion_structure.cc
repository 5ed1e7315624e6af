// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/coupled/motion_structure.h"

#include "fathom/vehicle/coupled/coriolis.h"
#include "fathom/vehicle/coupled/entry_value.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace fathom {
namespace {

constexpr std::array<std::string_view, 6> kStructureNames = {
    "diagonal", "coriolis", "lift", "symmetric", "full", "lopsided"};

// Surge, heave and pitch do not change sides in a mirror from port to starboard; the others do.
bool IsEven(Dof dof) { return dof == Dof::kSurge || dof == Dof::kHeave || dof == Dof::kPitch; }

using DofSet = std::array<bool, 6>;

DofSet SetOf(const std::vector<Dof>& dofs) {
  DofSet set = {};
  for (const Dof dof : dofs) set[Index(dof)] = true;
  return set;
}

// The parts of a graph over the six DOFs.
class Joined {
 public:
  void Join(int i, int j) {
    const int from = part_[i], to = part_[j];
    std::replace(part_.begin(), part_.end(), from, to);
  }
  int operator[](int i) const { return part_[i]; }

 private:
  std::array<int, 6> part_ = {0, 1, 2, 3, 4, 5};
};

// An entry that may be anything, as a number that no sum of others cancels.
double Generic(int i, int j) { return 2.0 + std::sin(1.0 + 7.0 * i + 13.0 * j); }

// Joins what a matrix of a force by velocities joins, among the modelled.
void JoinBy(const Matrix6& matrix, const DofSet& modelled, Joined* joined) {
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      if (modelled[i] && modelled[j] && matrix(i, j) != 0.0) joined->Join(i, j);
    }
  }
}

// Through the body's down in the world, which the turning DOFs move.
void JoinByAttitude(const CoupledModel& pattern,
                    const DofSet& modelled,
                    const DofSet& moves,
                    Joined* joined) {
  constexpr int kRollIndex = 3, kPitchIndex = 4, kYawIndex = 5;
  const bool rolls = moves[kRollIndex], pitches = moves[kPitchIndex], yaws = moves[kYawIndex];
  // Components of the down that leave what they are when the vehicle is level. Yaw alone tilts
  // nothing, but turns a tilt about.
  const std::array<bool, 3> varies = {
      pitches || (rolls && yaws), rolls || (pitches && yaws), rolls || pitches};
  const auto join_with_turns = [&](int dof) {
    if (!modelled[dof]) return;
    for (const int turn : {kRollIndex, kPitchIndex, kYawIndex}) {
      if (!modelled[turn]) continue;
      if (turn == kYawIndex && !rolls && !pitches) continue;
      joined->Join(dof, turn);
    }
  };
  if (pattern.net_buoyancy != 0.0) {
    for (int i = 0; i < 3; ++i) {
      if (varies[i]) join_with_turns(i);
    }
  }
  if (pattern.righting_roll != 0.0 && varies[1]) join_with_turns(kRollIndex);
  if (pattern.righting_pitch != 0.0 && varies[0]) join_with_turns(kPitchIndex);
}

// A model whose free entries are generic numbers.
CoupledModel PatternOf(const MotionStructure& structure, const CoupledModel& held) {
  CoupledModel pattern = held;
  for (const FreeEntry& entry : structure.entries) {
    SetValue(entry, Generic(Index(entry.row), Index(entry.column)), &pattern);
  }
  return pattern;
}

}  // namespace

std::string_view Name(StandardStructure structure) {
  return kStructureNames[static_cast<std::size_t>(structure)];
}

std::optional<StandardStructure> StandardStructureFromName(std::string_view name) {
  const auto found = std::find(kStructureNames.begin(), kStructureNames.end(), name);
  if (found == kStructureNames.end()) return std::nullopt;
  return static_cast<StandardStructure>(found - kStructureNames.begin());
}

MotionStructure StructureOf(StandardStructure standard,
                            const std::vector<Dof>& dofs,
                            const std::vector<StructureFin>& fins,
                            const std::vector<std::string>& gains) {
  MotionStructure structure = {dofs, {}, standard >= StandardStructure::kCoriolis};
  std::vector<FreeEntry>& entries = structure.entries;
  for (const Dof dof : dofs) {
    entries.push_back(InertiaEntry(dof, dof));
    entries.push_back(QuadraticDampingEntry(dof, dof));
    entries.push_back(LinearDampingEntry(dof, dof));
    entries.push_back(dof == Dof::kHeave ? NetBuoyancyEntry() : OffsetEntry(dof));
    if (dof == Dof::kRoll || dof == Dof::kPitch) entries.push_back(RightingMomentEntry(dof));
  }
  const auto add_pairs = [&](auto entry, bool both_ways) {
    for (const Dof row : dofs) {
      for (const Dof column : dofs) {
        const bool is_like = IsEven(row) == IsEven(column);
        if (row == column || !(is_like || standard == StandardStructure::kLopsided)) continue;
        if (row < column || both_ways) entries.push_back(entry(row, column));
      }
    }
  };
  for (const std::string& gain : gains) entries.push_back(ThrustGainEntry(gain));
  for (const StructureFin& fin : fins) {
    if (!fin.is_force_known) entries.push_back(FinForceEntry(fin.name));
    if (fin.is_in_race && standard >= StandardStructure::kLift) {
      entries.push_back(FinRaceEntry(fin.name));
    }
  }
  if (!fins.empty() && standard >= StandardStructure::kLift) {
    for (const Dof row : dofs) {
      if (row != Dof::kSurge && row != Dof::kRoll) entries.push_back(LiftEntry(row, row));
    }
    for (const auto& [a, b] : {std::pair{Dof::kSway, Dof::kYaw}, {Dof::kHeave, Dof::kPitch}}) {
      const auto has = [&](Dof dof) {
        return std::find(dofs.begin(), dofs.end(), dof) != dofs.end();
      };
      if (!has(a) || !has(b)) continue;
      entries.push_back(LiftEntry(a, b));
      entries.push_back(LiftEntry(b, a));
      entries.push_back(QuadraticDampingEntry(a, b));
      entries.push_back(QuadraticDampingEntry(b, a));
    }
  }
  if (standard >= StandardStructure::kSymmetric) add_pairs(InertiaEntry, false);
  if (standard == StandardStructure::kFull) add_pairs(LinearDampingEntry, true);
  return structure;
}

std::vector<std::vector<Dof>> BlocksOf(const MotionStructure& structure,
                                       const std::vector<Dof>& measured,
                                       const CoupledModel& held) {
  const DofSet modelled = SetOf(structure.dofs);
  DofSet moves = SetOf(measured);
  for (const Dof dof : structure.dofs) moves[Index(dof)] = true;
  const CoupledModel pattern = PatternOf(structure, held);
  Joined joined;
  JoinBy(pattern.inertia, modelled, &joined);
  JoinBy(pattern.linear_damping, modelled, &joined);
  JoinBy(pattern.quadratic_damping, modelled, &joined);
  JoinBy(pattern.lift, modelled, &joined);
  if ((pattern.thrust_angle != 0.0 || !pattern.current.empty()) && modelled[0] && modelled[1])
    joined.Join(0, 1);
  if (!pattern.fin_force.empty()) JoinBy(Matrix6::Ones(), modelled, &joined);  // by the fins' flow
  if (structure.coriolis) {
    Vector6 nu = Vector6::Zero();
    for (int i = 0; i < 6; ++i) {
      if (moves[i]) nu[i] = Generic(i, i + 1);
    }
    JoinBy(CoriolisJacobian(pattern.inertia, nu), modelled, &joined);
  }
  JoinByAttitude(pattern, modelled, moves, &joined);
  std::vector<std::vector<Dof>> blocks;
  for (const Dof dof : kAllDofs) {
    if (!modelled[Index(dof)]) continue;
    const auto home = std::find_if(blocks.begin(), blocks.end(), [&](const auto& block) {
      return joined[Index(block.front())] == joined[Index(dof)];
    });
    if (home == blocks.end()) {
      blocks.push_back({dof});
    } else {
      home->push_back(dof);
    }
  }
  return blocks;
}

}  // namespace fathom
