// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/ladder.h"

#include "fathom/coupled/momentum_start.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

namespace fathom {
namespace {

constexpr double kLeastErrors = 1.65;  // standard errors that a rung must win by
constexpr double kLeastShare = 1e-3;   // by which it must bring free runs nearer: less is rounding
constexpr double kMuchNearer = 20.0;   // -2 log likelihood of (6)

// What stands, with all entries of a standard structure and its C(nu).
MotionStructure Joined(MotionStructure stands, const MotionStructure& standard) {
  stands.coriolis = stands.coriolis || standard.coriolis;
  for (const FreeEntry& entry : standard.entries) {
    if (std::ranges::find(stands.entries, entry) == stands.entries.end()) {
      stands.entries.push_back(entry);
    }
  }
  return stands;
}

// Rungs one upon the other.
class Climb {
 public:
  Climb(const CoupledLogs& logs, const std::vector<Dof>& dofs, const CoupledFitOptions& options)
      : logs_(logs), dofs_(dofs), options_(options), folds_(FoldsOf(logs.data)) {}

  // Whether it stands.
  bool Try(std::string name, const MotionStructure& structure, CoupledSummary fit) {
    LadderRung& rung = ladder_.rungs.emplace_back();
    rung.name = std::move(name);
    rung.structure = structure;
    rung.fit = std::move(fit);
    UnseenErrors errors;
    if (rung.fit.IsUsable()) errors = UnseenErrorsOf(folds_, structure, rung.fit, options_);
    rung.unseen_nmae = NmaeOf(errors, dofs_);
    if (!errors.is_known) return false;
    if (stands_.is_known) rung.gain = GainOf(stands_, errors, dofs_);
    const bool wins =
        !stands_.is_known || (rung.gain.in_errors > kLeastErrors && rung.gain.share > kLeastShare);
    if (!wins) return false;
    rung.is_accepted = true;
    ladder_.accepted = ladder_.rungs.size() - 1;
    stands_ = std::move(errors);
    return true;
  }

  // The same of a fit from what stands, with its noise.
  bool Try(std::string name, const MotionStructure& structure) {
    CoupledFitOptions fit = options_;
    if (stands_.is_known) {
      fit.start = standing().fit.model;
      fit.noise = standing().fit.noise;
      fit.window_starts = standing().fit.starts;
    }
    return Try(std::move(name), structure, FitBlocks(logs_, structure, fit));
  }

  const LadderRung& standing() const { return ladder_.rungs[ladder_.accepted]; }
  Ladder Take() { return std::move(ladder_); }

 private:
  const CoupledLogs& logs_;
  const std::vector<Dof>& dofs_;
  const CoupledFitOptions& options_;
  const std::vector<Fold> folds_;
  Ladder ladder_;
  UnseenErrors stands_;
};

// A thruster or a fin that may be off.
struct SuspectActuator {
  MotionStructure structure;  // with its number
  NamedEntry named;
};

// What may be off with each: the gain of a thruster; of a fin of a known force that force, its
// neutral angle, or that it is stuck.
std::vector<FreeEntry> SuspectEntries(const EntrySearchOptions& options) {
  std::vector<FreeEntry> entries;
  for (const std::string& thruster : options.thrusters) {
    entries.push_back(ThrustGainEntry(thruster));
  }
  for (const StructureFin& fin : options.fins) {
    if (!fin.is_force_known) continue;
    entries.push_back(FinForceEntry(fin.name));
    entries.push_back(FinNeutralEntry(fin.name));
    entries.push_back(FinStuckEntry(fin.name));
  }
  return entries;
}

// The one whose number brings (6) nearest, if that is much nearer. Before a fit, since that of a
// model whose thruster is dead may end anywhere.
std::optional<SuspectActuator> MostSuspect(const CoupledLogs& logs,
                                           const MotionStructure& structure,
                                           const EntrySearchOptions& options) {
  const double without = MomentumMisfit(logs.data, structure, options.fit.held);
  const std::vector<FreeEntry> entries = SuspectEntries(options);
  std::vector<double> misfits;
  for (const FreeEntry& entry : entries) {
    MotionStructure longer = structure;
    longer.entries.push_back(entry);
    misfits.push_back(MomentumMisfit(logs.data, longer, options.fit.held));
  }
  const auto least = std::ranges::min_element(misfits);
  if (least == misfits.end() || !(*least < without - kMuchNearer)) return std::nullopt;
  SuspectActuator suspect = {structure, {}};
  for (std::size_t k = 0; k < misfits.size(); ++k) {
    if (misfits[k] == *least) {
      suspect.structure.entries.push_back(entries[k]);
      suspect.named.entry = entries[k];
    } else if (misfits[k] < *least + kMuchNearer) {
      suspect.named.not_told_apart.push_back(entries[k]);
    }
  }
  return suspect;
}

}  // namespace

Ladder ClimbLadder(const CoupledLogs& logs,
                   const std::vector<Dof>& dofs,
                   const EntrySearchOptions& options) {
  Climb climb(logs, dofs, options.fit);
  // Both from their own starts: what a model took for C(nu) leads astray.
  for (const auto standard : {StandardStructure::kDiagonal, StandardStructure::kCoriolis}) {
    const MotionStructure structure = StructureOf(standard, dofs, options.fins, options.gains);
    climb.Try(std::string(Name(standard)), structure, FitBlocks(logs, structure, options.fit));
  }
  std::vector<NamedEntry> named;
  const bool has_fins = !options.fins.empty();
  const MotionStructure highest =
      StructureOf(has_fins ? StandardStructure::kLift : StandardStructure::kCoriolis,
                  dofs,
                  options.fins,
                  options.gains);
  // Before `lift`, whose search goes far astray where a fin does not do what it is told.
  if (const auto suspect = MostSuspect(logs, highest, options)) {
    const FreeEntry& entry = suspect->named.entry;
    CoupledSummary fit = FitBlocks(logs, suspect->structure, options.fit);  // from its own start
    if (fit.IsUsable() && StrengthOf(fit, entry, options.fit.held) > kStillThere &&
        climb.Try(entry.kind == FreeEntry::Kind::kThrustGain ? "thruster" : "fin",
                  suspect->structure,
                  std::move(fit))) {
      named.push_back(suspect->named);
    }
  }
  if (has_fins && named.empty()) climb.Try("lift", highest);
  if (climb.standing().fit.IsUsable()) {
    const MotionStructure stands = climb.standing().structure;
    const EntrySearch search =
        SearchEntries(logs.data, {stands, climb.standing().fit, named}, options);
    if (search.structure.entries != stands.entries &&
        climb.Try("entries", search.structure, search.fit)) {
      named = search.named;
    }
  }
  for (const auto standard :
       {StandardStructure::kSymmetric, StandardStructure::kLopsided, StandardStructure::kFull}) {
    const MotionStructure& stands = climb.standing().structure;
    const MotionStructure structure =
        Joined(stands, StructureOf(standard, dofs, options.fins, options.gains));
    if (structure.entries.size() == stands.entries.size()) continue;
    // C(nu) of a diagonal inertia may lose where that of the whole one wins; from its own start.
    if (structure.coriolis != stands.coriolis) {
      climb.Try(std::string(Name(standard)), structure, FitBlocks(logs, structure, options.fit));
    } else {
      climb.Try(std::string(Name(standard)), structure);
    }
  }
  const CoupledSummary& last = climb.standing().fit;
  for (NamedEntry& entry : named) {
    entry.value = ValueIn(last.model, entry.entry);
    entry.std = StdOf(last, entry.entry);
    entry.without = WithoutEffect(entry.entry, options.fit.held);
  }
  Ladder ladder = climb.Take();
  ladder.named = std::move(named);
  return ladder;
}

}  // namespace fathom
