// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/judge/refutation.h"

#include "fathom/base/median.h"
#include "fathom/diagnosis/search/suspects.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

namespace fathom {
namespace {

constexpr int kMostInstead = 4;  // causes that are tried in the place of others

double TraceOf(const Gain& gain, const VerdictRules& rules) {
  return gain.is_in_poses ? rules.trace_in_poses : 0.0;
}

// For certain, by more than a trace, or by too much as far as the data go.
bool IsLoss(const Gain& gain, double trace, const VerdictRules& rules) {
  return gain.high < -trace || gain.value < -rules.loss_too_much;
}

// Whether the held-out data speak against a cause, from the runs without it and with it.
bool Loses(const Scored& scored, bool acts_on_poses_alone, const VerdictRules& rules) {
  const Gain in_velocities = GainOf(scored, false);
  const Gain gain = GainOf(scored, acts_on_poses_alone);
  const bool is_borne_out = gain.is_in_poses && gain.low > rules.material_gain_in_poses;
  return !is_borne_out &&
         (IsLoss(in_velocities, 0.0, rules) || IsLoss(gain, TraceOf(gain, rules), rules));
}

// The best hypothesis of at most so many causes without any of some suspects.
int BestWithout(const std::set<int>& left_out, size_t most_causes, const HypothesisBook& book) {
  int best = 0;
  for (int i = 0; i < book.size(); ++i) {
    const std::vector<int>& causes = book[i].suspects;
    const bool has_one = std::any_of(
        causes.begin(), causes.end(), [&](int suspect) { return left_out.contains(suspect); });
    if (has_one || causes.size() > most_causes || !IsPhysical(book[i])) continue;
    if (!(book[i].gain > book.calibration().ThresholdOf(causes))) continue;
    if (book[i].delta_bic > book[best].delta_bic) best = i;
  }
  return best;
}

// The median step between samples of the motion [s].
double StepOf(const TrainingData& data) {
  std::vector<double> steps;
  for (const MeasuredSegment& segment : data.segments()) {
    for (const auto& stamps : {segment.stamps.velocity, segment.stamps.displacement}) {
      for (std::size_t i = 1; i < stamps.size(); ++i) steps.push_back(stamps[i] - stamps[i - 1]);
    }
  }
  return steps.empty() ? 0.0 : Median(std::move(steps));
}

bool IsDuration(const Quantity& quantity) {
  return quantity.force == 0.0 && quantity.speed == 0.0 && quantity.time == 1.0;
}

// Whether all that a cause does is to shift or to slow, and by less than this [s].
bool IsFinerThan(double time, const Effect* effect, const ExtendedModel& model) {
  for (const ActiveEffect& active : model.effects) {
    if (active.effect != effect) continue;
    const std::vector<EffectParameter>& parameters = effect->info().parameters;
    for (std::size_t k = 0; k < parameters.size(); ++k) {
      const bool is_shift = IsDuration(parameters[k].quantity) && parameters[k].null == 0.0;
      if (!is_shift || std::abs(active.values[k]) >= time) return false;
    }
    return true;
  }
  return false;
}

// Leaves causes out of a choice one at a time, as long as more than `fewest` are left.
template <typename IsRefused>
Choice LeaveOut(const TrainingData& data,
                const WeighedSearch& search,
                std::size_t fewest,
                Refusal::Reason reason,
                const IsRefused& is_refused,
                Choice choice) {
  const HypothesisBook& book = search.found.book;
  std::set<int> left_out;
  while (book[choice.chosen].suspects.size() > fewest) {
    const std::vector<int>& causes = book[choice.chosen].suspects;
    const auto refused =
        std::ranges::find_if(causes, [&](int suspect) { return is_refused(choice, suspect); });
    if (refused == causes.end()) break;
    left_out.insert(*refused);
    const int next = BestWithout(left_out, causes.size() - 1, book);
    choice = WithChosen(data, search, next, std::move(choice));
    choice.refusals.push_back(
        {.reason = reason, .refused = {*refused}, .kept = book[choice.chosen].suspects});
  }
  return choice;
}

// The same by `speaks_against`(runs over the held-out segments without a cause and with it, whether
// poses judge it). A cause that was not tried without stays.
template <typename SpeaksAgainst>
Choice LeaveOutByRuns(const TrainingData& data,
                      const std::vector<MeasuredSegment>& held_out,
                      const WeighedSearch& search,
                      std::size_t fewest,
                      Refusal::Reason reason,
                      const SpeaksAgainst& speaks_against,
                      Choice choice) {
  const HypothesisBook& book = search.found.book;
  const auto is_refused = [&](const Choice& at, int suspect) {
    const int without = book.IndexWithout(at.chosen, suspect);
    if (without < 0) return false;
    const Scored runs = Score(held_out, FitOf(book, at, without).model, at.fit().model);
    return speaks_against(runs, ActOnPosesAlone({suspect}, search.suspects));
  };
  return LeaveOut(data, search, fewest, reason, is_refused, std::move(choice));
}

}  // namespace

Choice LeaveOutTheTooFine(const TrainingData& data, const WeighedSearch& search, Choice choice) {
  const double half_step = 0.5 * StepOf(data);
  const auto is_too_fine = [&](const Choice& at, int suspect) {
    return IsFinerThan(half_step, search.suspects[suspect].effect, at.fit().model);
  };
  return LeaveOut(
      data, search, 0, Refusal::Reason::kFinerThanTheStamps, is_too_fine, std::move(choice));
}

Choice LeaveOutWhatLoses(const TrainingData& data,
                         const std::vector<MeasuredSegment>& held_out,
                         const WeighedSearch& search,
                         const VerdictRules& rules,
                         Choice choice) {
  const auto loses = [&](const Scored& runs, bool by_poses) {
    return Loses(runs, by_poses, rules);
  };
  return LeaveOutByRuns(
      data, held_out, search, 1, Refusal::Reason::kLosesBesideOthers, loses, std::move(choice));
}

Choice LeaveOutWhatDoesNotGain(const TrainingData& data,
                               const std::vector<MeasuredSegment>& held_out,
                               const WeighedSearch& search,
                               const VerdictRules& rules,
                               Choice choice) {
  const auto does_not_gain = [&](const Scored& runs, bool by_poses) {
    return Loses(runs, by_poses, rules) || !(GainOf(runs, by_poses).low > 0.0);
  };
  return LeaveOutByRuns(
      data, held_out, search, 0, Refusal::Reason::kGainsNothing, does_not_gain, std::move(choice));
}

bool IsConfirmedByLogs(const Gain& gain, const VerdictRules& rules) {
  if (gain.low > 0.0) return true;
  return gain.num_better == gain.num_logs && gain.value > rules.least_gain_of_each_log;
}

Choice LeaveOutTheUnconfirmed(const TrainingData& data,
                              const LeftOutParts& logs,
                              const WeighedSearch& search,
                              const VerdictRules& rules,
                              Choice choice) {
  const HypothesisBook& book = search.found.book;
  std::map<int, Scored> scored;  // by hypothesis
  const auto runs_of = [&](int index) -> const Scored& {
    const auto found = scored.find(index);
    if (found != scored.end()) return found->second;
    return scored[index] = Score(logs, FitOf(book, choice, index), search.criterion);
  };
  // Nothing of a cause of one log alone, or where it was not tried without it.
  const auto gain_by = [&](int suspect) -> std::optional<Gain> {
    const int without = book.IndexWithout(choice.chosen, suspect);
    if (!search.suspects[suspect].setting.log.empty() || without < 0) return std::nullopt;
    const Scored beside = Beside(runs_of(without), runs_of(choice.chosen));
    return GainOf(beside, ActOnPosesAlone({suspect}, search.suspects));
  };
  std::set<int> left_out;
  for (int num_tried = 0; choice.chosen != 0; ++num_tried) {
    const std::vector<int> causes = book[choice.chosen].suspects;
    std::optional<Refusal> refusal;
    for (const int suspect : causes) {
      const auto gain = gain_by(suspect);
      if (!gain || IsConfirmedByLogs(*gain, rules)) continue;
      refusal = Refusal{
          .reason = Refusal::Reason::kNotConfirmedByLogs, .refused = {suspect}, .loss = *gain};
      break;
    }
    if (!refusal) break;
    left_out.insert(refusal->refused.front());
    const std::size_t most_causes = causes.size() - (num_tried < kMostInstead ? 0 : 1);
    const int next = BestWithout(left_out, most_causes, book);
    choice = WithChosen(data, search, next, std::move(choice));
    refusal->kept = book[choice.chosen].suspects;
    choice.refusals.push_back(*std::move(refusal));
  }
  return choice;
}

std::optional<Gain> RefutingGain(const Scored& scored,
                                 bool acts_on_poses_alone,
                                 const VerdictRules& rules) {
  const Gain gain = GainOf(scored, acts_on_poses_alone);
  if (IsLoss(gain, TraceOf(gain, rules), rules)) return gain;
  if (!gain.is_in_poses) return std::nullopt;
  const Gain in_velocities = GainOf(scored, false);
  if (IsLoss(in_velocities, rules.trace_in_velocities, rules)) return in_velocities;
  return std::nullopt;
}

std::optional<Refusal> RefusalOfAll(const std::vector<int>& causes,
                                    const FreeRunComparison& runs,
                                    bool by_left_out_blocks,
                                    bool remains,
                                    const VerdictRules& rules) {
  if (causes.empty()) return std::nullopt;
  const Gain& gain = runs.gain;
  if (runs.unseen.by_log) {
    // A cause may stand in for what else is missing, and two runs miss much the same.
    if (gain.num_logs < 3 && remains) {
      return Refusal{.reason = Refusal::Reason::kTwoLogsTellTooLittle, .refused = causes};
    }
    if (IsConfirmedByLogs(gain, rules)) return std::nullopt;
    return Refusal{.reason = Refusal::Reason::kNotConfirmedByLogs, .refused = causes, .loss = gain};
  }
  const auto loss = RefutingGain(runs.unseen, gain.is_in_poses, rules);
  // Of blocks left out in turn the models are refitted on less: only what is certain counts.
  const bool counts = !by_left_out_blocks || gain.is_in_poses || gain.high < 0.0;
  if (loss && counts) {
    return Refusal{.reason = Refusal::Reason::kLosesOnUnseenData, .refused = causes, .loss = *loss};
  }
  // Each may gain beside the others what they lose together.
  if (remains && !by_left_out_blocks && gain.low <= 0.0) {
    return Refusal{.reason = Refusal::Reason::kGainsNothing, .refused = causes};
  }
  const double before = runs.train_before.nmae, after = runs.train_after.nmae;
  if (!(after > (1.0 + rules.loss_too_much_in_training) * before)) return std::nullopt;
  return Refusal{.reason = Refusal::Reason::kLosesInTraining,
                 .refused = causes,
                 .nmae_before = before,
                 .nmae_after = after};
}

}  // namespace fathom
