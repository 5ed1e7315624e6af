// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled/coupled_fit.h"
#include "fathom/vehicle/coupled/free_entry.h"
#include "fathom/vehicle/coupled/motion_structure.h"

#include <span>
#include <string>
#include <vector>

namespace fathom {

struct EntrySearchOptions {
  CoupledFitOptions fit;

  // How likely an entry that is not there is taken, all candidates together. Between 0 and 1.
  double false_alarm = 0.01;

  std::vector<std::string> thrusters;   // whose gain may be off
  std::vector<StructureFin> fins;       // whose neutral angle, or known force, may be
  std::vector<std::string> gains = {};  // of thrusts that are not known: free throughout
};

// A number beyond a structure that the data show.
struct NamedEntry {
  FreeEntry entry;
  double value = 0.0;  // and its standard deviation [unit of the entry]
  double std = 0.0;
  std::vector<FreeEntry> not_told_apart;  // candidates that would do nearly as well
  double without = 0.0;                   // its value where it has no effect
};

// The standard deviation of an entry of a fit.
double StdOf(const CoupledSummary& fit, const FreeEntry& entry);

// What an entry is where it has no effect; infinite of a bound. `held`: the known forces of fins.
double WithoutEffect(const FreeEntry& entry, const CoupledModel& held);

// How far an entry is from where it has no effect, in standard deviations; of a bound, its inverse.
// Infinite of a stuck fin: no angle is without effect.
double StrengthOf(const CoupledSummary& fit, const FreeEntry& entry, const CoupledModel& held);

inline constexpr double kStillThere = 3.0;  // of these an entry that is named keeps

struct EntrySearch {
  MotionStructure structure;
  CoupledSummary fit;                  // of it
  std::vector<NamedEntry> named = {};  // in the order in which they were found
};

// Adds the entry that the data ask for most until they ask for none; an entry that a later one
// makes needless goes. Candidates: all off the diagonal of the inertia and of the linear damping,
// the gain of each thruster, the neutral angle of each fin and its force where that is known;
// docs/coupled.md. `begun`: a usable fit, and what another search has named in it.
EntrySearch SearchEntries(std::span<const CoupledData> logs,
                          EntrySearch begun,
                          const EntrySearchOptions& options);

}  // namespace fathom
