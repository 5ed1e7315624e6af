// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/entry_prior.h"

#include "fathom/vehicle/coupled/entry_value.h"

#include <algorithm>
#include <cmath>

namespace fathom {
namespace {

constexpr double kWithinFactorOfFour = 0.7;  // ln 4 / 1.96

bool IsAlongAxis(const FreeEntry& entry) { return Index(entry.row) < 3; }

}  // namespace

bool IsOwnInertia(const FreeEntry& entry) {
  return entry.kind == FreeEntry::Kind::kInertia && entry.row == entry.column;
}

void AddPriors(const CoupledModel& model,
               std::span<const FreeEntry> entries,
               std::span<const EntryPrior> priors,
               PhysicalBarrier* barrier) {
  for (const EntryPrior& prior : priors) {
    const auto at = std::ranges::find(entries, prior.entry) - entries.begin();
    if (at == std::ssize(entries)) continue;
    const double value = ValueIn(model, prior.entry);
    if (!(value > 0.0)) continue;  // the barrier's
    const double miss = std::log(value / prior.centre) / prior.log_std;
    const double slope = 1.0 / (prior.log_std * value);
    barrier->cost += 0.5 * miss * miss;
    barrier->gradient[at] += miss * slope;
    barrier->hessian(at, at) += slope * slope;
  }
}

std::vector<EntryPrior> InertiasAlike(const CoupledModel& model,
                                      std::span<const FreeEntry> open,
                                      std::span<const FreeEntry> told) {
  std::vector<EntryPrior> priors;
  for (const FreeEntry& entry : open) {
    if (!IsOwnInertia(entry)) continue;
    double sum = 0.0, num = 0.0;
    for (const FreeEntry& other : told) {
      if (!IsOwnInertia(other) || IsAlongAxis(other) != IsAlongAxis(entry)) continue;
      if (std::ranges::find(open, other) != open.end()) continue;
      sum += ValueIn(model, other);
      num += 1.0;
    }
    if (num > 0.0) priors.push_back({entry, sum / num, kWithinFactorOfFour});
  }
  return priors;
}

}  // namespace fathom
