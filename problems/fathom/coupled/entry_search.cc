// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/entry_search.h"

#include "fathom/coupled/entry_test.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

#include <Eigen/Cholesky>

namespace fathom {
namespace {

constexpr std::size_t kMostNamed = 8;
constexpr double kAlike = 0.9;  // correlation of two that are not told apart

// The two-sided quantile of a standard normal number: P(|z| > result) = p.
double NormalQuantile(double p) {
  double low = 0.0, high = 10.0;
  for (int i = 0; i < 60; ++i) {
    const double z = 0.5 * (low + high);
    (std::erfc(z / std::numbers::sqrt2) > p ? low : high) = z;
  }
  return low;
}

Eigen::Index PlaceOf(const CoupledSummary& fit, const FreeEntry& entry) {
  return std::ranges::find(fit.entries, entry) - fit.entries.begin();
}

bool Holds(const MotionStructure& structure, const FreeEntry& entry) {
  return std::find(structure.entries.begin(), structure.entries.end(), entry) !=
         structure.entries.end();
}

// Whether an entry is of a fin that no command turns.
bool IsOfStuckFin(const FreeEntry& entry, const MotionStructure& structure) {
  return IsOfActuator(entry) && Holds(structure, FinStuckEntry(entry.actuator));
}

// Everything off the diagonal, the thrusters and the fins.
std::vector<FreeEntry> CandidatesBeyond(const MotionStructure& structure,
                                        const EntrySearchOptions& options) {
  std::vector<FreeEntry> all;
  for (const Dof row : structure.dofs) {
    for (const Dof column : structure.dofs) {
      if (row == column) continue;
      if (row < column) all.push_back(InertiaEntry(row, column));
      all.push_back(LinearDampingEntry(row, column));
    }
  }
  const auto models = [&](Dof dof) { return std::ranges::count(structure.dofs, dof) > 0; };
  if (models(Dof::kSurge) && models(Dof::kSway)) all.push_back(ThrustAngleEntry());
  for (const std::string& thruster : options.thrusters) all.push_back(ThrustGainEntry(thruster));
  for (const StructureFin& fin : options.fins) {
    all.push_back(FinNeutralEntry(fin.name));
    if (fin.is_force_known) all.push_back(FinForceEntry(fin.name));
  }
  std::erase_if(all, [&](const FreeEntry& entry) {
    return Holds(structure, entry) || IsOfStuckFin(entry, structure);
  });
  return all;
}

// A start for one entry more, where its test puts it.
CoupledModel StartedAt(CoupledModel model, const EntryTest& test) {
  const double before = ValueIn(model, test.entry);
  SetValue(test.entry, before + test.value, &model);
  return model;
}

// The other candidates that would move the simulation as the `best` does.
std::vector<FreeEntry> Alike(const EntryTest& best, const std::vector<FreeEntry>& candidates) {
  std::vector<FreeEntry> alike;
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    if (std::abs(best.likeness[c]) > kAlike && !(candidates[c] == best.entry)) {
      alike.push_back(candidates[c]);
    }
  }
  return alike;
}

// Takes out the first that has become needless beside the others; true if there was one.
bool TakeOutNeedless(std::span<const CoupledData> logs,
                     const CoupledFitOptions& options,
                     EntrySearch* search,
                     std::vector<FreeEntry>* banned) {
  const auto needless = std::ranges::find_if(search->named, [&](const NamedEntry& named) {
    return StrengthOf(search->fit, named.entry, options.held) < kStillThere;
  });
  if (needless == search->named.end()) return false;
  const FreeEntry gone = needless->entry;
  banned->push_back(gone);
  search->named.erase(needless);
  std::erase(search->structure.entries, gone);
  CoupledFitOptions again = options;
  again.start = search->fit.model;
  again.noise = search->fit.noise;
  again.priors = search->fit.priors;
  SetValue(gone, WithoutEffect(gone, options.held), &*again.start);
  search->fit = FitCoupled(logs, search->structure, again);
  return search->fit.IsUsable();
}

}  // namespace

double StdOf(const CoupledSummary& fit, const FreeEntry& entry) {
  const Eigen::Index at = PlaceOf(fit, entry);
  return std::sqrt(fit.covariance(at, at));
}

double WithoutEffect(const FreeEntry& entry, const CoupledModel& held) {
  if (entry.kind == FreeEntry::Kind::kThrustGain) return 1.0;
  return entry.kind == FreeEntry::Kind::kFinForce ? ValueIn(held, entry) : 0.0;
}

double StrengthOf(const CoupledSummary& fit, const FreeEntry& entry, const CoupledModel& held) {
  if (entry.kind == FreeEntry::Kind::kFinStuck) return std::numeric_limits<double>::infinity();
  // Where a prior holds the scale of a DOF, what is unsure of that says nothing of whether the
  // entry is there.
  std::vector<Eigen::Index> given;
  for (const EntryPrior& prior : fit.priors) given.push_back(PlaceOf(fit, prior.entry));
  const Eigen::Index at = PlaceOf(fit, entry);
  const Eigen::VectorXd with = fit.covariance(given, at);
  const Eigen::MatrixXd of_given = fit.covariance(given, given);
  const double variance = fit.covariance(at, at) - with.dot(of_given.ldlt().solve(with));
  return std::abs(ValueIn(fit.model, entry) - WithoutEffect(entry, held)) / std::sqrt(variance);
}

EntrySearch SearchEntries(std::span<const CoupledData> logs,
                          EntrySearch begun,
                          const EntrySearchOptions& options) {
  EntrySearch search = std::move(begun);
  if (search.fit.starts.empty()) {
    // Blocks were fitted one by one; the tests need one run of all.
    CoupledFitOptions together = options.fit;
    together.start = search.fit.model;
    together.priors = search.fit.priors;
    search.fit = FitCoupled(logs, search.structure, together);
  }
  std::vector<FreeEntry> banned;
  while (TakeOutNeedless(logs, options.fit, &search, &banned)) {
  }
  while (search.fit.IsUsable() && search.named.size() < kMostNamed) {
    std::vector<FreeEntry> candidates = CandidatesBeyond(search.structure, options);
    std::erase_if(candidates, [&](const FreeEntry& entry) {
      return std::ranges::find(banned, entry) != banned.end();
    });
    if (candidates.empty()) break;
    const std::vector<EntryTest> tests = TestEntries(logs, search.fit, candidates, options.fit);
    const auto best =
        std::ranges::max_element(tests, {}, [](const EntryTest& test) { return std::abs(test.z); });
    const double least =
        NormalQuantile(options.false_alarm / static_cast<double>(candidates.size()));
    if (best == tests.end() || std::abs(best->z) < least) break;
    MotionStructure longer = search.structure;
    longer.entries.push_back(best->entry);
    CoupledFitOptions next = options.fit;
    next.start = StartedAt(search.fit.model, *best);
    next.noise = search.fit.noise;
    next.priors = search.fit.priors;
    CoupledSummary found = FitCoupled(logs, longer, next);
    if (!found.IsUsable() || StrengthOf(found, best->entry, options.fit.held) < kStillThere) {
      banned.push_back(best->entry);
      continue;
    }
    search.structure = std::move(longer);
    search.fit = std::move(found);
    search.named.push_back({best->entry, 0.0, 0.0, Alike(*best, candidates), 0.0});
    while (TakeOutNeedless(logs, options.fit, &search, &banned)) {
    }
  }
  if (!search.fit.IsUsable()) return search;
  for (NamedEntry& named : search.named) {
    named.value = ValueIn(search.fit.model, named.entry);
    named.std = StdOf(search.fit, named.entry);
  }
  return search;
}

}  // namespace fathom
