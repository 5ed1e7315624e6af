// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/ladder.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace fathom {
namespace {

constexpr double kLeastErrors = 1.65;  // standard errors that a rung must win by

// What stands, with all entries of a standard structure.
MotionStructure Joined(MotionStructure stands, const MotionStructure& standard) {
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
    if (rung.fit.converged) errors = UnseenErrorsOf(folds_, structure, rung.fit, options_);
    rung.unseen_nmae = NmaeOf(errors, dofs_);
    if (!errors.is_known) return false;
    if (stands_.is_known) rung.gain = GainOf(stands_, errors, dofs_);
    rung.is_accepted =
        rung.fit.IsUsable() && (!stands_.is_known || rung.gain.in_errors > kLeastErrors);
    if (!rung.is_accepted) return false;
    ladder_.accepted = ladder_.rungs.size() - 1;
    stands_ = std::move(errors);
    return true;
  }

  // The same of a fit from what stands.
  bool Try(std::string name, const MotionStructure& structure) {
    CoupledFitOptions fit = options_;
    if (stands_.is_known) fit.start = standing().fit.model;
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

}  // namespace

Ladder ClimbLadder(const CoupledLogs& logs,
                   const std::vector<Dof>& dofs,
                   const EntrySearchOptions& options) {
  Climb climb(logs, dofs, options.fit);
  for (const auto standard : {StandardStructure::kDiagonal, StandardStructure::kCoriolis}) {
    climb.Try(std::string(Name(standard)), StructureOf(standard, dofs));
  }
  std::vector<NamedEntry> named;
  if (climb.standing().fit.IsUsable()) {
    EntrySearch search =
        SearchEntries(logs.data, climb.standing().structure, climb.standing().fit, options);
    if (!search.named.empty() && climb.Try("entries", search.structure, std::move(search.fit))) {
      named = std::move(search.named);
    }
  }
  for (const auto standard : {StandardStructure::kSymmetric, StandardStructure::kFull}) {
    const MotionStructure& stands = climb.standing().structure;
    const MotionStructure structure = Joined(stands, StructureOf(standard, dofs));
    if (structure.entries.size() > stands.entries.size()) {
      climb.Try(std::string(Name(standard)), structure);
    }
  }
  Ladder ladder = climb.Take();
  ladder.named = std::move(named);
  return ladder;
}

}  // namespace fathom
