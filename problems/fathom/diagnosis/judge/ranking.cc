// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/judge/ranking.h"

#include "fathom/diagnosis/measures/experiments.h"
#include "fathom/diagnosis/search/suspects.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace fathom {
namespace {

// What stands in for a cause in the rivals that are without it: by suspect, as often as it does.
std::vector<int> StandingIn(const HypothesisBook& book, const Judgement& judgement, int cause) {
  const Hypothesis& best = book[judgement.choice.chosen];
  std::vector<int> standing_in;
  for (const int rival : judgement.rivals) {
    if (book[rival].Has(cause)) continue;
    for (const int suspect : book[rival].suspects) {
      if (!best.Has(suspect)) standing_in.push_back(suspect);
    }
  }
  return standing_in;
}

// True of a suspect that stands in for any cause.
bool IsRival(const HypothesisBook& book, const Judgement& judgement, int suspect) {
  const auto& rivals = judgement.rivals;
  return !book[judgement.choice.chosen].Has(suspect) &&
         std::any_of(
             rivals.begin(), rivals.end(), [&](int rival) { return book[rival].Has(suspect); });
}

bool IsRefused(const Judgement& judgement, int suspect) {
  return std::any_of(judgement.choice.refusals.begin(),
                     judgement.choice.refusals.end(),
                     [&](const Refusal& refusal) {
                       return std::find(refusal.refused.begin(), refusal.refused.end(), suspect) !=
                              refusal.refused.end();
                     });
}

// `score` and `gain` are there already.
CandidateOutcome OutcomeOf(const Candidate& candidate,
                           const HypothesisBook& book,
                           const Judgement& judgement,
                           int suspect) {
  using enum CandidateOutcome;
  if (book[judgement.choice.chosen].Has(suspect)) {
    return candidate.gain > candidate.noise_reach ? kKept : kKeptBesideOthers;
  }
  if (IsRival(book, judgement, suspect)) return kAlternative;
  if (std::isnan(candidate.gain)) {
    if (book.HasFailed({suspect})) return kFitFailed;
    return candidate.score < candidate.noise_reach ? kScoreWithinNoise : kOthersScoreHigher;
  }
  if (candidate.gain < candidate.noise_reach) return kGainWithinNoise;
  if (judgement.choice.chosen != 0) return kNeedless;
  if (judgement.choice.refusals.empty()) return kTakenUpByNoise;
  return IsRefused(judgement, suspect) ? kRefused : kNoBetterThanRefused;
}

// What came of a suspect by itself; nothing of the rest of the judgement.
Candidate CandidateOf(const Suspect& suspect, double score, const StructureFit* alone) {
  Candidate candidate;
  candidate.effect = suspect.effect;
  candidate.setting = suspect.setting;
  candidate.label = LabelOf(suspect);
  candidate.score = score;
  candidate.gain = std::numeric_limits<double>::quiet_NaN();
  if (alone == nullptr) return candidate;
  candidate.values = alone->model.effects[0].values;
  for (size_t i = 0; i < candidate.values.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(kNumParameters + i);
    candidate.stds.push_back(std::sqrt(alone->covariance(at, at)));
  }
  return candidate;
}

}  // namespace

std::vector<Cause> CausesOf(const Judgement& judgement) {
  const HypothesisBook& book = judgement.book();
  const std::vector<Suspect>& suspects = judgement.search.suspects;
  const int chosen = judgement.choice.chosen;
  const Hypothesis& best = book[chosen];
  std::vector<Cause> causes;
  for (const int suspect : best.suspects) {
    Cause cause;
    cause.effect_index = PlaceIn(judgement.choice.fit().model, suspects[suspect]);
    const int without = book.IndexWithout(chosen, suspect);
    const double own_gain = without < 0 ? best.gain : best.gain - book[without].gain;
    cause.delta_bic = without < 0 ? best.delta_bic : best.delta_bic - book[without].delta_bic;
    cause.p_value = book.calibration().significance.FamilyWisePValue(suspect, own_gain);
    std::vector<Suspect> rivals;
    for (const int index : StandingIn(book, judgement, suspect)) {
      rivals.push_back(suspects[index]);
      const auto& [effect, setting] = suspects[index];
      cause.alternatives.push_back({effect, setting, LabelOf(suspects[index])});
    }
    if (!rivals.empty()) cause.experiment = DecidingExperiment(suspects[suspect], rivals);
    causes.push_back(std::move(cause));
  }
  std::sort(causes.begin(), causes.end(), [](const Cause& a, const Cause& b) {
    return a.effect_index < b.effect_index;
  });
  return causes;
}

std::vector<Candidate> RankCandidates(const Judgement& judgement) {
  const HypothesisBook& book = judgement.book();
  const std::vector<Suspect>& suspects = judgement.search.suspects;
  const std::vector<double>& scores = judgement.search.found.scores;
  const Significance& significance = book.calibration().significance;
  std::vector<Candidate> candidates;
  for (int k = 0; k < static_cast<int>(suspects.size()); ++k) {
    const int alone = book.IndexOf({k});
    Candidate candidate = CandidateOf(
        suspects[k], scores[k], alone < 0 ? nullptr : &FitOf(book, judgement.choice, alone));
    if (alone >= 0) {
      candidate.gain = book[alone].gain;
      candidate.delta_bic = book[alone].delta_bic;
    }
    const double gain = std::isnan(candidate.gain) ? candidate.score : candidate.gain;
    candidate.p_value = significance.FamilyWisePValue(k, gain);
    candidate.noise_reach = significance.Threshold(k);
    candidate.outcome = OutcomeOf(candidate, book, judgement, k);
    candidates.push_back(std::move(candidate));
  }
  const auto worth = [](const Candidate& candidate) {
    return std::isnan(candidate.gain) ? candidate.score - 1e6 : candidate.gain;
  };
  std::stable_sort(candidates.begin(), candidates.end(), [&](const auto& a, const auto& b) {
    if (a.IsKept() != b.IsKept()) return a.IsKept();
    return worth(a) > worth(b);
  });
  return candidates;
}

ExtendedModel WithoutCause(const Judgement& judgement, const Cause& cause) {
  const HypothesisBook& book = judgement.book();
  const Choice& choice = judgement.choice;
  const std::vector<Suspect>& suspects = judgement.search.suspects;
  const ExtendedModel& model = choice.fit().model;
  for (const int suspect : book[choice.chosen].suspects) {
    if (PlaceIn(model, suspects[suspect]) != cause.effect_index) continue;
    const int without = book.IndexWithout(choice.chosen, suspect);
    if (without >= 0) return FitOf(book, choice, without).model;
  }
  return WithoutEffect(model, cause.effect_index);
}

}  // namespace fathom
