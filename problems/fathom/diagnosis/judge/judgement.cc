// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/judge/judgement.h"

#include "fathom/diagnosis/fit/residual_noise.h"
#include "fathom/diagnosis/judge/free_run_ladder.h"
#include "fathom/diagnosis/measures/left_out_blocks.h"
#include "fathom/diagnosis/search/suspects.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace fathom {
namespace {

RemainingStructure RemainingOf(const Prepared& prepared, const Choice& choice) {
  if (LeavesNothing(prepared.data, choice.fit())) return {.is_negligible = true};
  return FindRemainingStructure(prepared.data, choice.fit());
}

// True if what a hypothesis that gains so much leaves is more than noise, and a matter. Where there
// is no baseline to gain over, it is a matter of what is left of the error: of a share of its
// square much below 1 the gain is as many times the number of samples.
bool Remains(const Prepared& prepared,
             const RemainingStructure& remaining,
             double gain,
             double clear,
             double material) {
  const double all_structure = prepared.has_baseline
                                   ? gain + remaining.gain
                                   : static_cast<double>(prepared.data.bins().size());
  return remaining.p_value < clear &&
         remaining.gain - remaining.num_columns > material * all_structure;
}

bool Remains(const Prepared& prepared,
             const RemainingStructure& remaining,
             double gain,
             const VerdictRules& rules) {
  return Remains(prepared, remaining, gain, RemainingStructure::kClear, rules.material_rest);
}

// The best hypothesis that all training data call for, less what the held-out data refuse.
Choice BestConfirmed(const Prepared& prepared,
                     const LeftOutParts& parts,
                     const WeighedSearch& search,
                     const VerdictRules& rules) {
  const TrainingData& data = prepared.data;
  const auto gain_of = [&](const Choice& at) { return search.found.book[at.chosen].gain; };
  Choice choice = ConfirmedOnAllData(data, search);
  // Unless what is too fine to be told from sampling matters.
  Choice coarse = LeaveOutTheTooFine(data, search, choice);
  if (!coarse.refusals.empty() &&
      !Remains(prepared, RemainingOf(prepared, coarse), gain_of(choice), rules)) {
    choice = std::move(coarse);
  }
  choice = LeaveOutWhatLoses(data, prepared.held_out, search, rules, std::move(choice));
  if (prepared.held_out.empty()) {
    if (parts.how != LeavingOut::kLogs || choice.chosen == 0) return choice;
    return LeaveOutTheUnconfirmed(data, parts, search, rules, std::move(choice));
  }
  if (!Remains(prepared, RemainingOf(prepared, choice), gain_of(choice), rules)) return choice;
  // The causes may stand in for what nothing explains; unseen data tell.
  return LeaveOutWhatDoesNotGain(data, prepared.held_out, search, rules, std::move(choice));
}

// Separation from rivals. What nothing explains gains so much per column: then it takes as many
// times more to tell two causes apart, either of which may stand in for it.
double SeparationBeside(const RemainingStructure& remaining, bool remains, double separation) {
  if (!remains) return separation;
  const double times_noise = remaining.gain / remaining.num_columns;
  return separation * std::max(1.0, times_noise);
}

// The first cause of a run alone that may be one. By likelihood: what a free run misses is no
// noise.
std::optional<Coincidence> CoincidenceIn(const WeighedSearch& search,
                                         int chosen,
                                         double separation) {
  if (search.criterion != Criterion::kLearnedNoise) return std::nullopt;
  const HypothesisBook& book = search.found.book;
  for (const int suspect : book[chosen].suspects) {
    const EffectInfo& info = search.suspects[suspect].effect->info();
    const int without = book.IndexWithout(chosen, suspect);
    if (!info.depends_on_time || without < 0) continue;
    const double own_gain =
        book[chosen].gain - book[without].gain - static_cast<double>(info.parameters.size());
    const FreeForm form = BestFreeForm(search.thinned, book[without].fit);
    if (!form.input.empty() && form.gain > own_gain - separation) {
      return Coincidence{LabelOf(search.suspects[suspect]), std::string(form.input)};
    }
  }
  return std::nullopt;
}

Verdict VerdictOf(bool is_open, bool is_named, bool has_rivals) {
  if (is_open) return Verdict::kUnexplained;
  if (!is_named) return Verdict::kConsistent;
  return has_rivals ? Verdict::kAmbiguous : Verdict::kExplained;
}

// What comes of a choice that unseen data do not refuse as a whole.
Judgement Concluded(const Prepared& prepared,
                    WeighedSearch search,
                    Choice choice,
                    FreeRunComparison runs,
                    const Evidence& evidence,
                    const DiagnosisOptions& options) {
  const HypothesisBook& book = search.found.book;
  const RemainingStructure left = RemainingOf(prepared, choice);
  const VerdictRules& rules = options.rules;
  const auto refusal = RefusalOfAll(book[choice.chosen].suspects,
                                    runs,
                                    prepared.held_out.empty(),
                                    Remains(prepared, left, book[choice.chosen].gain, rules),
                                    rules);
  if (refusal) {
    choice.chosen = 0;
    choice.refusals.push_back(*refusal);
    runs = OfUsersAlone(std::move(runs));
  }
  const int chosen = choice.chosen;
  RemainingStructure remaining = refusal ? RemainingOf(prepared, choice) : left;
  const bool remains = Remains(prepared, remaining, book[chosen].gain, rules);
  const double separation = SeparationBeside(remaining, remains, options.separation);
  std::vector<int> rivals = FindRivals(book, chosen, SeparationOn(prepared.data, separation));
  const bool is_suspected = runs.unseen.by_log && chosen == 0 && !choice.refusals.empty();
  Verdict verdict = VerdictOf(remains || refusal || is_suspected, chosen != 0, !rivals.empty());
  std::optional<Coincidence> coincidence;
  // By likelihood: what a free run misses is no noise.
  if (verdict == Verdict::kExplained && !remaining.is_negligible &&
      search.criterion == Criterion::kLearnedNoise) {
    const RemainingStructure of_one = FindRemainingOfOneInput(prepared.data, choice.fit());
    if (Remains(prepared,
                of_one,
                book[chosen].gain,
                rules.clear_rest_of_one_input,
                rules.material_rest_of_one_input)) {
      remaining = of_one;
      verdict = Verdict::kUnexplained;
    }
  }
  if (verdict == Verdict::kExplained) coincidence = CoincidenceIn(search, chosen, separation);
  const bool is_only_cut = verdict == Verdict::kExplained && !coincidence && search.found.is_cut;
  if (coincidence || is_only_cut) verdict = Verdict::kUnexplained;
  return {verdict,
          std::move(search),
          std::move(choice),
          std::move(rivals),
          evidence,
          std::move(runs),
          remaining,
          std::move(coincidence),
          is_only_cut};
}

DiagnosisOptions AtFirst(DiagnosisOptions options) {
  options.effort *= options.rules.share_of_work_at_first;
  return options;
}

// Whether unseen data speak against a hypothesis of a search by likelihood for certain.
bool IsRefuted(const Prepared& prepared,
               const LeftOutParts& parts,
               const std::vector<Suspect>& suspects,
               const Hypothesis& hypothesis,
               const VerdictRules& rules) {
  if (HowToLeaveOut(prepared.data, hypothesis.fit.model) != parts.how) return false;
  const Scored unseen = UnseenRuns(prepared, parts, hypothesis.fit, Criterion::kLearnedNoise);
  const auto loss = RefutingGain(unseen, ActOnPosesAlone(hypothesis.suspects, suspects), rules);
  return loss && loss->high < 0.0;
}

// Of one search by likelihood. What is refuted is not built upon. `parts`: what is left out in turn
// where no cause belongs to a log alone.
Judgement JudgedOnce(const Prepared& prepared,
                     const std::shared_ptr<const LeftOutParts>& parts,
                     const std::vector<Suspect>& suspects,
                     const Evidence& evidence,
                     const DiagnosisOptions& options) {
  const auto ends = [&](const HypothesisBook& book, int size) {
    const Hypothesis& best = book[book.best()];
    return std::ssize(best.suspects) == size &&
           IsRefuted(prepared, *parts, suspects, best, options.rules);
  };
  WeighedSearch search = SearchByLikelihood(prepared, suspects, options, ends);
  Choice choice = BestConfirmed(prepared, *parts, search, options.rules);
  const std::vector<int>& causes = search.found.book[choice.chosen].suspects;
  const LeavingOut how = HowToLeaveOut(prepared.data, choice.fit().model);
  FreeRunComparison runs = CompareWithUsers(
      prepared,
      how == parts->how ? parts : std::make_shared<const LeftOutParts>(LeaveOut(prepared, how)),
      choice.fit(),
      search.criterion,
      ActOnPosesAlone(causes, search.suspects));
  if (causes.empty()) runs = OfUsersAlone(std::move(runs));
  return Concluded(
      prepared, std::move(search), std::move(choice), std::move(runs), evidence, options);
}

// A search that was ended has its whole work where what it found leaves nothing but noise: only
// there can more of it change what is said.
Judgement JudgedByLikelihood(const Prepared& prepared,
                             const std::shared_ptr<const LeftOutParts>& parts,
                             const std::vector<Suspect>& suspects,
                             const Evidence& evidence,
                             const DiagnosisOptions& options) {
  Judgement at_first = JudgedOnce(prepared, parts, suspects, evidence, AtFirst(options));
  const bool is_open = at_first.verdict == Verdict::kUnexplained && !at_first.is_only_cut;
  if (is_open || !at_first.search.found.is_cut) return at_first;
  return JudgedOnce(prepared, parts, suspects, evidence, options);
}

// True if the free run of what is named leaves more than the sensors' scatter: something may be
// missing that the noise has taken up.
bool LeavesMoreThanScatter(const Prepared& prepared,
                           const Judgement& judgement,
                           const VerdictRules& rules) {
  const Choice& choice = judgement.choice;
  return WanderRatio(prepared.data,
                     choice.chosen == 0 ? prepared.users.residual : choice.fit().residual) >
         rules.more_than_scatter;
}

// Whether likelihood does not speak against what free runs propose: with the noise learned along it
// is at least better than the baseline by BIC. Turbulence wears an effect's form now and then.
bool IsLikely(const Prepared& prepared, const StructureFit& proposed) {
  const TrainingData& data = prepared.data;
  const StructureFit& baseline = prepared.baseline;
  StructureFit fit = FitStructureAndNoise(data, proposed.model, proposed.initial, baseline.noise);
  // Worse than with less: the search went astray. It begins at the baseline instead.
  if (!(fit.log_likelihood > baseline.log_likelihood)) {
    ExtendedModel model = proposed.model;
    model.baseline = baseline.model.baseline;
    fit = FitStructureAndNoise(data, model, baseline.initial, baseline.noise);
  }
  const auto num_more = static_cast<double>(fit.covariance.rows() - kNumParameters);
  const double price = num_more * std::log(static_cast<double>(data.bins().size()));
  return 2.0 * (fit.log_likelihood - baseline.log_likelihood) > price;
}

// Whether what free runs propose is named where likelihood names nothing: it predicts unseen data
// better for certain.
bool IsNamed(const Prepared& prepared,
             const Judgement& by_likelihood,
             const Rung& rung,
             const VerdictRules& rules) {
  const Scored& standing = by_likelihood.runs.unseen;
  return rung.choice.chosen != 0 && AreOverTheSame(standing.after, rung.runs.unseen.after) &&
         IsBetterForCertain(GainOf(Beside(standing, rung.runs.unseen), false), rules) &&
         IsLikely(prepared, rung.choice.fit());
}

}  // namespace

Judgement Judge(const Prepared& prepared,
                const std::vector<Suspect>& suspects,
                const Evidence& evidence,
                const DiagnosisOptions& options) {
  const auto parts =
      std::make_shared<const LeftOutParts>(LeaveOut(prepared, HowToLeaveOut(prepared.data, {})));
  std::optional<Judgement> by_likelihood;
  if (prepared.has_baseline) {
    by_likelihood = JudgedByLikelihood(prepared, parts, suspects, evidence, options);
    if (by_likelihood->choice.chosen != 0 ||
        LeavesNothing(prepared.data, by_likelihood->choice.fit()) ||
        !LeavesMoreThanScatter(prepared, *by_likelihood, options.rules)) {
      return *std::move(by_likelihood);
    }
  }
  const DiagnosisOptions wanted = by_likelihood ? AtFirst(options) : options;
  const auto climbed = [&](const WeighedSearch& search) {
    return ClimbByFreeRuns(prepared, search, parts, wanted.most_causes, options.rules);
  };
  // Beside what likelihood says, several are looked for only where one alone predicts better.
  bool is_over = false;
  const auto ends = [&](const WeighedSearch& search, int size) {
    is_over = by_likelihood && size == 1 && climbed(search).choice.chosen == 0;
    return is_over;
  };
  WeighedSearch search = SearchByFreeRuns(prepared, suspects, wanted, ends);
  if (is_over) return *std::move(by_likelihood);
  Rung rung = climbed(search);
  if (by_likelihood && !IsNamed(prepared, *by_likelihood, rung, options.rules)) {
    return *std::move(by_likelihood);
  }
  return Concluded(
      prepared, std::move(search), std::move(rung.choice), std::move(rung.runs), evidence, options);
}

}  // namespace fathom
