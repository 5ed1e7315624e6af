// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/entry_search.h"

#include "fathom/coupled/entry_test.h"
#include "fathom/solve/decompositions.h"
#include "fathom/vehicle/coupled/coupled_effects.h"
#include "fathom/vehicle/coupled/entry_value.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

namespace fathom {
namespace {

constexpr std::size_t kMostNamed = 8;
constexpr double kAlike = 0.9;          // correlation of two that are not told apart
constexpr double kAboutAsStrong = 3.0;  // z by which another test may be weaker
constexpr double kAsNear = 3.3;         // log likelihood: 1 % of such pairs

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

// Everything off the diagonal, the thrusters, the fins, the effects, and what is of each log.
std::vector<FreeEntry> CandidatesBeyond(std::span<const CoupledData> logs,
                                        const MotionStructure& structure,
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
  if (models(Dof::kSurge) && models(Dof::kSway)) {
    all.push_back(ThrustAngleEntry());
    // Known by the name of its log, and told by the heading.
    for (const CoupledData& log : logs) {
      const bool is_named_once = std::ranges::count(logs, log.log, &CoupledData::log) == 1;
      if (!log.has_attitude || !is_named_once) continue;
      for (const Dof axis : {Dof::kSurge, Dof::kSway}) all.push_back(CurrentEntry(axis, log.log));
    }
  }
  // One log's own is its offset.
  for (const CoupledData& log : logs) {
    if (logs.size() == 1 || std::ranges::count(logs, log.log, &CoupledData::log) != 1) continue;
    for (const Dof dof : structure.dofs) all.push_back(RunOffsetEntry(dof, log.log));
  }
  for (const std::string& thruster : options.thrusters) all.push_back(ThrustGainEntry(thruster));
  for (const StructureFin& fin : options.fins) {
    all.push_back(FinNeutralEntry(fin.name));
    if (fin.is_force_known) all.push_back(FinForceEntry(fin.name));
  }
  for (const Dof dof : structure.dofs) {
    for (const auto effects : {WaterEffects(), ThrustEffects()}) {
      for (const Effect* effect : effects) all.push_back(EffectEntry(*effect, dof));
    }
  }
  for (const Effect* effect : ThrustEffects()) all.push_back(ThrusterEffectEntry(*effect));
  std::erase_if(all, [&](const FreeEntry& entry) {
    return Holds(structure, entry) || IsOfStuckFin(entry, structure);
  });
  return all;
}

// The fit of one entry more, from where its test puts it.
CoupledSummary FitWith(std::span<const CoupledData> logs,
                       const EntrySearch& search,
                       const EntryTest& test,
                       const CoupledFitOptions& with) {
  MotionStructure longer = search.structure;
  longer.entries.push_back(test.entry);
  CoupledFitOptions options = BegunAt(search.fit, with);
  SetValue(test.entry, ValueIn(search.fit.model, test.entry) + test.value, &*options.start);
  return FitCoupled(logs, longer, options);
}

// What that fit costs under the noise of the search; infinite where it leads nowhere.
double CostWith(std::span<const CoupledData> logs,
                const EntrySearch& search,
                const EntryTest& test,
                CoupledFitOptions options) {
  options.learns_noise = false;
  const CoupledSummary fit = FitWith(logs, search, test, options);
  const bool counts = fit.converged && MayBe(test.entry, ValueIn(fit.model, test.entry));
  return counts ? fit.cost : std::numeric_limits<double>::infinity();
}

// What the data ask for most, and what would do nearly as well.
struct Wanted {
  EntryTest test;
  std::vector<FreeEntry> not_told_apart = {};
};

// The others that would move the simulation as one does.
std::vector<FreeEntry> Alike(const EntryTest& one, const std::vector<EntryTest>& tests) {
  std::vector<FreeEntry> alike;
  for (std::size_t k = 0; k < tests.size(); ++k) {
    if (std::abs(one.likeness[k]) > kAlike && !(tests[k].entry == one.entry)) {
      alike.push_back(tests[k].entry);
    }
  }
  return alike;
}

// The strongest test. Near 0 it tells effects badly from one another and from couplings: of those
// about as strong each is fitted, to the same noise, and the nearest is wanted.
Wanted MostWanted(std::span<const CoupledData> logs,
                  const EntrySearch& search,
                  const std::vector<EntryTest>& tests,
                  double least,
                  const CoupledFitOptions& options) {
  const auto strength = [](const EntryTest& test) { return std::abs(test.z); };
  const EntryTest& strongest = *std::ranges::max_element(tests, {}, strength);
  const double strong = std::max(least, strength(strongest) - kAboutAsStrong);
  std::vector<const EntryTest*> rivals;
  for (const EntryTest& test : tests) {
    const bool tells_badly = IsEffect(test.entry) || IsEffect(strongest.entry);
    if (&test == &strongest || (tells_badly && strength(test) >= strong)) rivals.push_back(&test);
  }
  Wanted wanted = {strongest, Alike(strongest, tests)};
  if (rivals.size() == 1) return wanted;
  std::vector<double> costs;
  for (const EntryTest* rival : rivals) costs.push_back(CostWith(logs, search, *rival, options));
  const auto nearest = std::ranges::min_element(costs);
  if (!std::isfinite(*nearest)) return wanted;
  wanted = {*rivals[static_cast<std::size_t>(nearest - costs.begin())]};
  for (std::size_t k = 0; k < rivals.size(); ++k) {
    const bool is_as_near = costs[k] < *nearest + kAsNear;
    if (is_as_near && !(rivals[k]->entry == wanted.test.entry)) {
      wanted.not_told_apart.push_back(rivals[k]->entry);
    }
  }
  return wanted;
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
  CoupledFitOptions again = BegunAt(search->fit, options);
  SetValue(gone, WithoutEffect(gone, options.held), &*again.start);
  search->fit = FitCoupled(logs, search->structure, again);
  return search->fit.IsUsable();
}

// The fit of a structure to the noise that another fit learned, from its model.
CoupledSummary FitToNoiseOf(std::span<const CoupledData> logs,
                            const MotionStructure& structure,
                            const CoupledSummary& fit,
                            const CoupledFitOptions& with) {
  CoupledFitOptions options = BegunAt(fit, with);
  options.learns_noise = false;
  return FitCoupled(logs, structure, options);
}

// Those of the rivals of a named entry that do nearly as well in its place beside all that was
// found. When it was added, what was found later stood in the residuals, and rivals took it up.
std::vector<FreeEntry> StillRivals(std::span<const CoupledData> logs,
                                   const EntrySearch& search,
                                   const NamedEntry& named,
                                   const CoupledFitOptions& options) {
  const CoupledSummary with = FitToNoiseOf(logs, search.structure, search.fit, options);
  EntrySearch without = search;
  std::erase(without.structure.entries, named.entry);
  SetValue(named.entry, WithoutEffect(named.entry, options.held), &without.fit.model);
  without.fit = FitToNoiseOf(logs, without.structure, without.fit, options);
  if (!with.converged || !without.fit.converged) return named.not_told_apart;
  std::vector<FreeEntry> rivals;
  for (const EntryTest& test : TestEntries(logs, without.fit, named.not_told_apart, options)) {
    const bool is_as_near = CostWith(logs, without, test, options) < with.cost + kAsNear;
    if (is_as_near) rivals.push_back(test.entry);
  }
  return rivals;
}

}  // namespace

double StdOf(const CoupledSummary& fit, const FreeEntry& entry) {
  const Eigen::Index at = PlaceOf(fit, entry);
  return std::sqrt(fit.covariance(at, at));
}

double WithoutEffect(const FreeEntry& entry, const CoupledModel& held) {
  if (entry.kind == FreeEntry::Kind::kThrustGain) return 1.0;
  if (IsLimit(entry)) return std::numeric_limits<double>::infinity();
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
  const double variance = fit.covariance(at, at) - with.dot(SolveSymmetric(of_given, with));
  // 1 / limit is as many of its own standard deviations from 0 as the limit is of its.
  const double without = IsLimit(entry) ? 0.0 : WithoutEffect(entry, held);
  return std::abs(ValueIn(fit.model, entry) - without) / std::sqrt(variance);
}

EntrySearch SearchEntries(std::span<const CoupledData> logs,
                          EntrySearch begun,
                          const EntrySearchOptions& options) {
  const std::vector<NamedEntry> given = begun.named;
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
    std::vector<FreeEntry> candidates = CandidatesBeyond(logs, search.structure, options);
    std::erase_if(candidates, [&](const FreeEntry& entry) {
      return std::ranges::find(banned, entry) != banned.end();
    });
    if (candidates.empty()) break;
    std::vector<EntryTest> tests = TestEntries(logs, search.fit, candidates, options.fit);
    for (EntryTest& test : tests) {
      if (!MayBe(test.entry, ValueIn(search.fit.model, test.entry) + test.value)) test.z = 0.0;
    }
    const double least =
        NormalQuantile(options.false_alarm / static_cast<double>(candidates.size()));
    if (std::ranges::none_of(tests, [&](const EntryTest& t) { return std::abs(t.z) >= least; })) {
      break;
    }
    const Wanted wanted = MostWanted(logs, search, tests, least, options.fit);
    const FreeEntry& entry = wanted.test.entry;
    CoupledSummary found = FitWith(logs, search, wanted.test, options.fit);
    if (!found.IsUsable() || !MayBe(entry, ValueIn(found.model, entry)) ||
        StrengthOf(found, entry, options.fit.held) < kStillThere) {
      banned.push_back(entry);
      continue;
    }
    search.structure.entries.push_back(entry);
    search.fit = std::move(found);
    search.named.push_back({entry, 0.0, 0.0, wanted.not_told_apart, 0.0});
    while (TakeOutNeedless(logs, options.fit, &search, &banned)) {
    }
  }
  if (!search.fit.IsUsable()) return search;
  for (NamedEntry& named : search.named) {
    named.value = ValueIn(search.fit.model, named.entry);
    named.std = StdOf(search.fit, named.entry);
    const bool is_given = std::ranges::count(given, named.entry, &NamedEntry::entry) > 0;
    if (is_given || named.not_told_apart.empty()) continue;
    named.not_told_apart = StillRivals(logs, search, named, options.fit);
  }
  return search;
}

}  // namespace fathom
