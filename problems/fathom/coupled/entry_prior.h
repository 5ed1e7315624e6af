// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled/physical_barrier.h"
#include "fathom/vehicle/coupled/coupled_model.h"
#include "fathom/vehicle/coupled/free_entry.h"

#include <span>
#include <vector>

namespace fathom {

// What is known of a number above 0 before any data: ln(value) is normal about ln(centre).
struct EntryPrior {
  FreeEntry entry;
  double centre = 1.0;   // [unit of the entry]
  double log_std = 1.0;  // 1: a factor of 2.7

  bool operator==(const EntryPrior&) const = default;
};

// Whether it is the inertia of one DOF.
bool IsOwnInertia(const FreeEntry& entry);

// Adds half the squares of all priors, docs/coupled.md (8), and what a small step of the entries
// changes of them.
void AddPriors(const CoupledModel& model,
               std::span<const FreeEntry> entries,
               std::span<const EntryPrior> priors,
               PhysicalBarrier* barrier);

// For inertias that data leave open, `open`, those of the axes alike: along an axis as large as the
// mean of the others along axes, about one likewise, each within a factor of four in 95 %. Not for
// one without its like among `told`.
std::vector<EntryPrior> InertiasAlike(const CoupledModel& model,
                                      std::span<const FreeEntry> open,
                                      std::span<const FreeEntry> told);

}  // namespace fathom
