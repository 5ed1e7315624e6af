// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/structure_ladder.h"

#include "fathom/coupled/entry_test.h"
#include "fathom/coupled/momentum_start.h"
#include "fathom/vehicle/coupled/entry_name.h"
#include "fathom/vehicle/coupled/entry_value.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>

namespace fathom {
namespace {

constexpr double kLeastErrors = 1.65;  // standard errors that a rung must win by
constexpr double kLeastShare = 1e-3;   // by which it must bring free runs nearer: less is rounding
constexpr double kAskedFor = 0.05;     // p-value of the numbers of a structure
constexpr double kMuchNearer = 20.0;   // -2 log likelihood of (6)

// How late commands may act [s].
constexpr std::array<double, 13> kTimesTried = {
    -2.0, -1.0, -0.5, -0.2, 0.1, 0.2, 0.3, 0.5, 0.7, 1.0, 1.5, 2.5, 4.0};

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
    errors_.push_back(errors);
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

  // Whether rung `a` is nearer to unseen motion than rung `b`, for certain.
  bool IsNearer(std::size_t a, std::size_t b) const {
    return errors_[a].is_known && errors_[b].is_known &&
           GainOf(errors_[b], errors_[a], dofs_).in_errors > kLeastErrors;
  }

  std::size_t num_rungs() const { return ladder_.rungs.size(); }
  const LadderRung& standing() const { return ladder_.rungs[ladder_.accepted]; }
  Ladder Take() { return std::move(ladder_); }

 private:
  const CoupledLogs& logs_;
  const std::vector<Dof>& dofs_;
  const CoupledFitOptions& options_;
  const std::vector<Fold> folds_;
  Ladder ladder_;
  std::vector<UnseenErrors> errors_;  // by rung
  UnseenErrors stands_;
};

// Whether the data ask for the numbers that a structure has beyond that of a fit, all together.
// Others bring unseen runs nearer by chance alone.
bool AreAskedFor(const CoupledLogs& logs,
                 const MotionStructure& structure,
                 const LadderRung& standing,
                 const CoupledFitOptions& options) {
  if (standing.fit.starts.empty()) return true;  // fitted block by block: no test is of all
  std::vector<FreeEntry> more = structure.entries;
  std::erase_if(more, [&](const FreeEntry& entry) {
    return std::ranges::count(standing.structure.entries, entry) > 0;
  });
  const std::vector<EntryTest> tests = TestEntries(logs.data, standing.fit, more, options);
  return tests.empty() || JointPValue(tests) < kAskedFor;
}

// Whether (6) is linear near a value of it only, so that some are tried.
bool IsTried(const FreeEntry& entry) { return IsLateness(entry) || IsLimit(entry); }

// Whether both say how a fin follows its command, which (6) tells badly.
bool AreAlike(const FreeEntry& a, const FreeEntry& b) {
  using Kind = FreeEntry::Kind;
  const auto is_of_servo = [](const FreeEntry& entry) {
    return entry.kind == Kind::kFinLag || entry.kind == Kind::kFinRateLimit;
  };
  return is_of_servo(a) && is_of_servo(b) && a.actuator == b.actuator;
}

// A number that says how the thrusters and fins may be off.
struct Suspect {
  FreeEntry entry;
  CoupledModel held;    // near which (6) is linear in it
  double misfit = 0.0;  // of (6)
};

// What may be off with each: the gain of a thruster; of a fin of a known force that force, its
// neutral angle, or that it is stuck; how late they act, how fast a fin turns and where it
// stalls, at some values that are tried.
std::vector<Suspect> SuspectsOf(const EntrySearchOptions& options) {
  const CoupledModel& held = options.fit.held;
  std::vector<Suspect> suspects;
  for (const std::string& thruster : options.thrusters) {
    suspects.push_back({ThrustGainEntry(thruster), held});
  }
  std::vector<FreeEntry> limits, late = {TimeOffsetEntry(), ThrusterLagEntry()};
  for (const StructureFin& fin : options.fins) {
    late.push_back(FinLagEntry(fin.name));
    limits.push_back(FinRateLimitEntry(fin.name));
    limits.push_back(FinStallEntry(fin.name));
    if (!fin.is_force_known) continue;
    suspects.push_back({FinForceEntry(fin.name), held});
    suspects.push_back({FinNeutralEntry(fin.name), held});
    suspects.push_back({FinStuckEntry(fin.name), held});
  }
  for (const FreeEntry& entry : late) {
    for (const double time : kTimesTried) {
      if (time < 0.0 && IsLag(entry)) continue;
      suspects.push_back({entry, held});
      SetValue(entry, time, &suspects.back().held);
    }
  }
  for (const FreeEntry& entry : limits) {
    for (const double limit : LimitsTried(entry)) {
      suspects.push_back({entry, held});
      SetValue(entry, limit, &suspects.back().held);
    }
  }
  return suspects;
}

// Those whose number brings (6) much nearer, each once, the nearest first. Before a fit, since that
// of a model whose thruster is dead may end anywhere.
std::vector<Suspect> MostSuspect(const CoupledLogs& logs,
                                 const MotionStructure& structure,
                                 const EntrySearchOptions& options) {
  const double without = MomentumMisfit(logs.data, structure, options.fit.held);
  std::vector<Suspect> nearer;
  for (Suspect& suspect : SuspectsOf(options)) {
    MotionStructure longer = structure;
    // A time or a bound as tried, since a free one beside it fits (6) to anything.
    if (!IsTried(suspect.entry)) longer.entries.push_back(suspect.entry);
    suspect.misfit = MomentumMisfit(logs.data, longer, suspect.held);
    if (suspect.misfit < without - kMuchNearer) nearer.push_back(std::move(suspect));
  }
  std::ranges::stable_sort(nearer, {}, &Suspect::misfit);
  std::vector<Suspect> most;
  for (Suspect& suspect : nearer) {
    if (std::ranges::find(most, suspect.entry, &Suspect::entry) == most.end()) {
      most.push_back(std::move(suspect));
    }
  }
  return most;
}

std::string RungOf(const FreeEntry& entry) {
  if (entry.actuator.empty()) return NameOf(entry);
  return entry.kind == FreeEntry::Kind::kThrustGain ? "thruster" : "fin";
}

// Tries the suspects; the one that stands then, or none. To (6), whose pieces are coarse, a little
// lateness may seem to be there: one that a fit finds to be none gives way to the next. Of several
// as near all are fitted that say how late a command acts or how fast a fin turns, since a fit
// tells them apart; a lag and a limited rate of one fin both, however near.
std::optional<NamedEntry> TrySuspects(const CoupledLogs& logs,
                                      const MotionStructure& structure,
                                      const EntrySearchOptions& options,
                                      Climb* climb) {
  struct Tried {
    FreeEntry entry;
    double misfit = 0.0;
    std::optional<std::size_t> rung = {};
  };
  std::vector<Tried> tried;
  std::optional<Tried> stands;
  bool thrust_is_prompt = false;
  for (const Suspect& suspect : MostSuspect(logs, structure, options)) {
    const bool is_as_near = !stands || suspect.misfit < stands->misfit + kMuchNearer;
    if (!is_as_near && !AreAlike(suspect.entry, stands->entry)) continue;
    const bool is_tried = IsTried(suspect.entry);
    if (stands && !is_tried) {
      tried.push_back({suspect.entry, suspect.misfit});
      continue;
    }
    const bool is_of_thrust = is_tried && suspect.entry.actuator.empty();
    if (is_of_thrust && thrust_is_prompt) continue;
    MotionStructure longer = structure;
    longer.entries.push_back(suspect.entry);
    CoupledFitOptions from = options.fit;
    from.held = suspect.held;
    CoupledSummary fit = FitBlocks(logs, longer, from);  // from its own start
    const bool is_there =
        fit.IsUsable() && StrengthOf(fit, suspect.entry, options.fit.held) > kStillThere;
    // An offset that is none leaves no lag, nor the other way round.
    if (is_of_thrust && fit.IsUsable() && !is_there) thrust_is_prompt = true;
    if (is_there) {
      tried.push_back({suspect.entry, suspect.misfit, climb->num_rungs()});
      if (climb->Try(RungOf(suspect.entry), longer, std::move(fit))) stands = tried.back();
    }
    if (!is_tried && !stands) break;
  }
  if (!stands) return std::nullopt;
  NamedEntry named;
  named.entry = stands->entry;
  for (const Tried& other : tried) {
    if (other.entry == named.entry) continue;
    const bool is_as_near = other.misfit < stands->misfit + kMuchNearer;
    if (!is_as_near && !AreAlike(other.entry, named.entry)) continue;
    if (!other.rung || !climb->IsNearer(*stands->rung, *other.rung)) {
      named.not_told_apart.push_back(other.entry);
    }
  }
  return named;
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
  if (const auto suspect = TrySuspects(logs, highest, options, &climb)) named.push_back(*suspect);
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
  std::vector<std::string> not_asked_for;
  for (const auto standard :
       {StandardStructure::kSymmetric, StandardStructure::kLopsided, StandardStructure::kFull}) {
    const MotionStructure& stands = climb.standing().structure;
    const MotionStructure structure =
        Joined(stands, StructureOf(standard, dofs, options.fins, options.gains));
    if (structure.entries.size() == stands.entries.size()) continue;
    // C(nu) of a diagonal inertia may lose where that of the whole one wins; from its own start.
    if (structure.coriolis != stands.coriolis) {
      climb.Try(std::string(Name(standard)), structure, FitBlocks(logs, structure, options.fit));
    } else if (!AreAskedFor(logs, structure, climb.standing(), options.fit)) {
      not_asked_for.emplace_back(Name(standard));
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
  ladder.not_asked_for = std::move(not_asked_for);
  return ladder;
}

}  // namespace fathom
