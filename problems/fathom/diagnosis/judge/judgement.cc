// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/judge/judgement.h"

#include "fathom/diagnosis/judge/left_out_blocks.h"
#include "fathom/diagnosis/search/suspects.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace fathom {
namespace {

constexpr double kMaterialShare = 0.05;  // of all structure, below which the rest is no matter
constexpr double kLossTooMuchInTraining = 0.1;  // of NMAE, at which nothing is named

RemainingStructure RemainingOf(const Prepared& prepared,
                               const Choice& choice,
                               const Evidence& evidence) {
  if (evidence.IsNegligible()) return {};
  return FindRemainingStructure(prepared.data, choice.fit());
}

// True if what a hypothesis that gains so much leaves is more than noise, and a matter.
bool Remains(const RemainingStructure& remaining, double gain) {
  const double all_structure = gain + remaining.gain;
  return remaining.p_value < RemainingStructure::kClear &&
         remaining.gain - remaining.num_columns > kMaterialShare * all_structure;
}

// The best hypothesis that all training data call for, less what the held-out data refuse.
Sifted SiftedBest(const Prepared& prepared,
                  const std::vector<Suspect>& suspects,
                  const SearchResult& search,
                  const Evidence& evidence,
                  std::uint64_t seed) {
  const auto sift = [&](Choice choice, Burden burden) {
    return LeaveOutTheRefuted(
        prepared.data, prepared.held_out, suspects, search.book, burden, seed, std::move(choice));
  };
  Sifted sifted =
      sift(ConfirmedOnAllData(prepared.data, prepared.baseline, search), Burden::kNotToLose);
  if (prepared.held_out.empty()) return sifted;
  const double gain = search.book[sifted.choice.chosen].gain;
  if (!Remains(RemainingOf(prepared, sifted.choice, evidence), gain)) return sifted;
  // The causes may stand in for what nothing explains; unseen data tell.
  Sifted strict = sift(std::move(sifted.choice), Burden::kToGain);
  strict.refusals.insert(strict.refusals.begin(), sifted.refusals.begin(), sifted.refusals.end());
  return strict;
}

// Of free runs over the training data.
FitFigures TrainFigures(const TrainingData& data,
                        const ExtendedModel& model,
                        const std::vector<InitialState>& initial) {
  std::vector<FreeRun> runs;
  for (size_t r = 0; r < data.segments().size(); ++r) {
    if (auto run = FreeRunOver(data.segments()[r], model, initial[r])) {
      runs.push_back(std::move(*run));
    }
  }
  return FiguresOfRuns(runs);
}

// Nothing is named: the user's model twice.
FreeRunComparison OfUsersAlone(FreeRunComparison runs, std::uint64_t seed) {
  runs.train_after = runs.train_before;
  runs.unseen.after = runs.unseen.before;
  runs.unseen.poses_after = runs.unseen.poses_before;
  runs.gain = GainOf(runs.unseen, false, seed);
  return runs;
}

FreeRunComparison RunsOf(const Prepared& prepared,
                         const Choice& choice,
                         bool acts_on_poses_alone,
                         std::uint64_t seed) {
  const StartedModel& users = prepared.users;
  const StructureFit& fit = choice.fit();
  FreeRunComparison runs;
  runs.unseen = prepared.held_out.empty() ? LeaveBlocksOut(prepared.data, users.model, fit)
                                          : Score(prepared.held_out, users.model, fit.model);
  runs.train_before = TrainFigures(prepared.data, users.model, users.initial);
  if (choice.chosen == 0) return OfUsersAlone(std::move(runs), seed);
  runs.train_after = TrainFigures(prepared.data, fit.model, fit.initial);
  runs.gain = GainOf(runs.unseen, acts_on_poses_alone, seed);
  return runs;
}

// Why nothing of what was chosen is to be named after all; nothing if it is.
std::optional<Refusal> RefusalOfAll(const std::vector<int>& causes,
                                    const FreeRunComparison& runs,
                                    bool by_left_out_blocks,
                                    std::uint64_t seed) {
  if (causes.empty()) return std::nullopt;
  const Gain& gain = runs.gain;
  const auto loss = RefutingGain(runs.unseen, gain.is_in_poses, seed);
  // Of blocks left out in turn the models are refitted on less: only what is certain counts.
  const bool counts = !by_left_out_blocks || gain.is_in_poses || gain.high < 0.0;
  if (loss && counts) {
    return Refusal{.reason = Refusal::Reason::kLosesOnUnseenData, .refused = causes, .loss = *loss};
  }
  const double before = runs.train_before.nmae, after = runs.train_after.nmae;
  if (!(after > (1.0 + kLossTooMuchInTraining) * before)) return std::nullopt;
  return Refusal{.reason = Refusal::Reason::kLosesInTraining,
                 .refused = causes,
                 .nmae_before = before,
                 .nmae_after = after};
}

// Separation from rivals. What nothing explains gains so much per column: then it takes as many
// times more to tell two causes apart, either of which may stand in for it.
double SeparationBeside(const RemainingStructure& remaining, bool remains, double separation) {
  if (!remains) return separation;
  const double times_noise = remaining.gain / remaining.num_columns;
  return separation * std::max(1.0, times_noise);
}

Verdict VerdictOf(bool is_open, bool is_named, bool has_rivals) {
  if (is_open) return Verdict::kUnexplained;
  if (!is_named) return Verdict::kConsistent;
  return has_rivals ? Verdict::kAmbiguous : Verdict::kExplained;
}

}  // namespace

Judgement Judge(const Prepared& prepared,
                const std::vector<Suspect>& suspects,
                const SearchResult& search,
                const Evidence& evidence,
                const DiagnosisOptions& options) {
  const HypothesisBook& book = search.book;
  Sifted sifted = SiftedBest(prepared, suspects, search, evidence, options.seed);
  const std::vector<int>& causes = book[sifted.choice.chosen].suspects;
  FreeRunComparison runs =
      RunsOf(prepared, sifted.choice, ActOnPosesAlone(causes, suspects), options.seed);
  const auto refusal = RefusalOfAll(causes, runs, prepared.held_out.empty(), options.seed);
  if (refusal) {
    sifted.choice.chosen = 0;
    sifted.refusals.push_back(*refusal);
    runs = OfUsersAlone(std::move(runs), options.seed);
  }
  const int chosen = sifted.choice.chosen;
  const RemainingStructure remaining = RemainingOf(prepared, sifted.choice, evidence);
  const bool remains = Remains(remaining, book[chosen].gain);
  const double separation = SeparationBeside(remaining, remains, options.separation);
  std::vector<int> rivals = FindRivals(book, chosen, SeparationOn(prepared.data, separation));
  const Verdict verdict = VerdictOf(remains || refusal, chosen != 0, !rivals.empty());
  return {verdict,
          std::move(sifted.choice),
          std::move(rivals),
          std::move(sifted.refusals),
          evidence,
          std::move(runs),
          remaining};
}

}  // namespace fathom
