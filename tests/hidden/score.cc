// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "score.h"

#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fathom::hidden {
namespace {

constexpr double kNormal95 = 1.959964;

// A cause as it is reported: what it may be.
struct Reported {
  std::string label;
  std::vector<std::string> alternatives;

  bool IsCertain() const { return alternatives.empty(); }
  bool MayBe(const std::string& other) const {
    return label == other ||
           std::find(alternatives.begin(), alternatives.end(), other) != alternatives.end();
  }
};

std::vector<Reported> ReportedCauses(const Diagnosis& diagnosis) {
  std::vector<Reported> causes;
  for (const Cause& cause : diagnosis.causes) {
    const auto& effect = diagnosis.extended.model.effects.at(cause.effect_index);
    Reported reported = {LabelOf(effect), {}};
    for (const Alternative& other : cause.alternatives) {
      reported.alternatives.push_back(other.label);
    }
    causes.push_back(std::move(reported));
  }
  return causes;
}

// Can each cause stand for an effect of its own? There are at most three of each.
bool Match(const std::vector<Reported>& causes, std::vector<std::string> hidden) {
  if (causes.size() != hidden.size()) return false;
  std::sort(hidden.begin(), hidden.end());
  do {
    bool all = true;
    for (std::size_t i = 0; i < causes.size(); ++i) all = all && causes[i].MayBe(hidden[i]);
    if (all) return true;
  } while (std::next_permutation(hidden.begin(), hidden.end()));
  return false;
}

Outcome OutcomeOf(const std::vector<Reported>& causes,
                  Verdict verdict,
                  const std::vector<std::string>& hidden) {
  if (causes.empty()) return Outcome::kAbstained;
  const auto is_hidden = [&](const Reported& cause) {
    return std::any_of(
        hidden.begin(), hidden.end(), [&](const auto& label) { return cause.MayBe(label); });
  };
  bool all_certain = true, any_certain_wrong = false, all_hidden = true, any_hidden = false;
  for (const Reported& cause : causes) {
    all_certain = all_certain && cause.IsCertain();
    any_certain_wrong = any_certain_wrong || (cause.IsCertain() && !is_hidden(cause));
    all_hidden = all_hidden && is_hidden(cause);
    any_hidden = any_hidden || is_hidden(cause);
  }
  if (Match(causes, hidden)) {
    return all_certain && verdict == Verdict::kExplained ? Outcome::kAlone : Outcome::kGroup;
  }
  // Structure that is said to remain is not a certain answer.
  if (any_certain_wrong) {
    return verdict == Verdict::kUnexplained ? Outcome::kGroupWithout : Outcome::kWrong;
  }
  if (all_hidden && causes.size() < hidden.size()) return Outcome::kPart;
  return any_hidden && causes.size() <= hidden.size() ? Outcome::kPart : Outcome::kGroupWithout;
}

void Count(double value, double variance, double truth, Coverage* coverage) {
  const double std = std::sqrt(variance);
  if (!std::isfinite(std) || !(std > 0.0)) {
    ++coverage->missing;
    return;
  }
  ++coverage->total;
  if (std::abs(value - truth) <= kNormal95 * std) ++coverage->inside;
}

// The same vehicle with thrust_curve's F0 elsewhere: all forces, and so all parameters, change by
// (F0'/F0)^(1 - p).
double ForceFactor(const ExtendedModel& truth, const ExtendedModel& fitted) {
  for (const ActiveEffect& hidden : truth.effects) {
    if (hidden.effect->info().name != "thrust_curve") continue;
    for (const ActiveEffect& named : fitted.effects) {
      if (named.effect != hidden.effect) continue;
      return std::pow(named.setting.reference_force / hidden.setting.reference_force,
                      hidden.values[0] - 1.0);
    }
  }
  return 1.0;
}

void CountCoverage(const HiddenLog& hidden, const DiagnosedModel& fitted, LogScore* score) {
  const ExtendedModel& truth = hidden.truth.model;
  const auto variance = [&](Eigen::Index i) {
    return i < fitted.covariance.rows() ? fitted.covariance(i, i) : std::nan("");
  };
  const ParameterVector fitted_baseline = ToVector(fitted.model.baseline);
  const ParameterVector true_baseline = ToVector(truth.baseline) * ForceFactor(truth, fitted.model);
  for (int i = 0; i < kNumParameters; ++i) {
    Count(fitted_baseline[i], variance(i), true_baseline[i], &score->model_parameters);
  }
  Eigen::Index column = kNumParameters;
  for (const ActiveEffect& named : fitted.model.effects) {
    const auto same =
        std::find_if(truth.effects.begin(), truth.effects.end(), [&](const ActiveEffect& effect) {
          return LabelOf(effect) == LabelOf(named);
        });
    for (std::size_t i = 0; i < named.values.size(); ++i, ++column) {
      if (same == truth.effects.end()) continue;
      Count(named.values[i], variance(column), same->values[i], &score->effect_parameters);
    }
  }
}

}  // namespace

std::string_view Name(Outcome outcome) {
  switch (outcome) {
    case Outcome::kAlone:
      return "alone";
    case Outcome::kGroup:
      return "group";
    case Outcome::kPart:
      return "part";
    case Outcome::kAbstained:
      return "abstained";
    case Outcome::kGroupWithout:
      return "group without it";
    case Outcome::kWrong:
      return "wrong";
  }
  return "";
}

void Coverage::Add(const Coverage& other) {
  inside += other.inside;
  total += other.total;
  missing += other.missing;
}

LogScore ScoreOf(const HiddenLog& hidden, const OracleAnswer& oracle, const Diagnosis& diagnosis) {
  LogScore score;
  score.name = hidden.plan.Name();
  score.setup = hidden.truth.setup;
  score.hidden = hidden.plan.hidden;
  score.oracle = oracle;
  score.verdict = diagnosis.verdict;
  std::vector<std::string> labels;
  for (const ActiveEffect& effect : hidden.truth.model.effects) {
    labels.push_back(LabelOf(effect));
    score.effects.emplace_back(effect.effect->info().name);
  }
  const std::vector<Reported> causes = ReportedCauses(diagnosis);
  for (std::size_t i = 0; i < causes.size(); ++i) {
    score.named += (i > 0 ? "; " : "") + causes[i].label;
    for (const std::string& other : causes[i].alternatives) score.named += " / " + other;
    const int effect_index = diagnosis.causes[i].effect_index;
    const ActiveEffect& effect = diagnosis.extended.model.effects[effect_index];
    if (causes[i].IsCertain()) score.certain.emplace_back(effect.effect->info().name);
  }
  score.outcome = OutcomeOf(causes, diagnosis.verdict, labels);
  if (oracle.held_out_baseline > 0.0) {
    score.gain = 1.0 - HeldOutNmae(hidden, diagnosis.extended.model) / oracle.held_out_baseline;
    score.oracle_gain = 1.0 - oracle.held_out_truth / oracle.held_out_baseline;
  }
  const bool is_right = hidden.plan.hidden == HiddenClass::kNothing
                            ? causes.empty()
                            : score.outcome == Outcome::kAlone;
  if (is_right) CountCoverage(hidden, diagnosis.extended, &score);
  return score;
}

}  // namespace fathom::hidden
