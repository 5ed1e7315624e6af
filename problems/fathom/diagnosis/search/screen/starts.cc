// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/search/screen/starts.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace fathom {

Starts::Starts(const TrainingData& data,
               const std::vector<Suspect>& suspects,
               std::shared_ptr<const FitAndTrials> about,
               const Whitener& whitener)
    : data_(&data),
      suspects_(&suspects),
      about_(std::move(about)),
      whitener_(whitener),
      screen_(about_->fit, &about_->trials, whitener),
      by_suspect_(suspects.size()) {
  const std::vector<Trial>& trials = about_->trials.trials;
  for (size_t t = 0; t < trials.size(); ++t) {
    by_suspect_[trials[t].suspect].push_back(static_cast<int>(t));
  }
  for (auto& own : by_suspect_) {
    std::stable_sort(own.begin(), own.end(), [&](int a, int b) {
      return screen_.scores()[a] > screen_.scores()[b];
    });
  }
}

double Starts::Score(int suspect) const {
  const auto& own = by_suspect_[suspect];
  return own.empty() ? 0.0 : screen_.scores()[own.front()];
}

double Starts::BestScore() const {
  const auto& scores = screen_.scores();
  return scores.empty() ? 0.0 : *std::max_element(scores.begin(), scores.end());
}

ActiveEffect Starts::BestTrialOf(int suspect) const {
  const Suspect& tried = (*suspects_)[suspect];
  return {tried.effect, tried.setting, about_->trials.trials[by_suspect_[suspect].front()].values};
}

std::vector<Start> Starts::Of(int suspect, int most) const {
  std::vector<int> chosen;
  for (const int trial : by_suspect_[suspect]) {
    if (static_cast<int>(chosen.size()) == most) break;
    if (screen_.scores()[trial] <= 0.0 && !chosen.empty()) break;
    const bool is_new = std::none_of(
        chosen.begin(), chosen.end(), [&](int other) { return std::abs(other - trial) <= 1; });
    if (is_new) chosen.push_back(trial);
  }
  std::vector<Start> starts;
  for (const int trial : chosen) starts.push_back(NarrowedDown(trial));
  return starts;
}

Start Starts::StartAt(const Trial& trial, double score, const std::vector<double>& amounts) const {
  const Suspect& suspect = (*suspects_)[trial.suspect];
  const EffectInfo& info = suspect.effect->info();
  std::vector<double> values = trial.values;
  for (size_t k = 0; k < trial.amounts.size(); ++k) {
    const EffectParameter& parameter = info.parameters[trial.amounts[k]];
    double& value = values[trial.amounts[k]];
    if (parameter.search == Search::kAmount) {
      value = parameter.null + amounts[k] * (value - parameter.null);
    }
    value = std::clamp(value, parameter.lower, parameter.upper);
  }
  return {score, 0, {suspect.effect, suspect.setting, std::move(values)}};
}

Start Starts::NarrowedDown(int trial) const {
  const Trial& from = about_->trials.trials[trial];
  Start start = StartAt(from, screen_.scores()[trial], screen_.amounts()[trial]);
  const Trials nearby = TrialsNear(*data_, about_->fit, *suspects_, from);
  if (!nearby.trials.empty()) {
    const Screen screen(about_->fit, &nearby, whitener_);
    for (size_t t = 0; t < nearby.trials.size(); ++t) {
      if (screen.scores()[t] <= start.score) continue;
      start = StartAt(nearby.trials[t], screen.scores()[t], screen.amounts()[t]);
    }
  }
  start.trial = trial;
  return start;
}

bool IsElsewhere(const ActiveEffect& effect, const ActiveEffect& other, double duration) {
  constexpr double kNearInTime = 1.0;  // [s]
  const EffectInfo& info = effect.effect->info();
  for (size_t k = 0; k < info.parameters.size(); ++k) {
    const double way = std::abs(effect.values[k] - other.values[k]);
    if (info.parameters[k].search == Search::kTimeOfRun && way > kNearInTime) return true;
    if (info.parameters[k].search == Search::kFrequencyOfRun && way > std::numbers::pi / duration) {
      return true;
    }
  }
  return false;
}

}  // namespace fathom
