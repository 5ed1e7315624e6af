// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/search.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include <glog/logging.h>

namespace fathom {
namespace {

constexpr int kNullDraws = 512;
constexpr int kBeam = 3;                // hypotheses that are carried on from each size
constexpr int kMostRefined = 10;        // suspects refitted about one hypothesis
constexpr int kMostRefinedMore = 4;     // and about one with causes
constexpr double kRough = 1e-3;         // share of the error at which a first fit is near enough
constexpr double kLeastShare = 0.3;     // of the best one's gain, below which one is not carried on
constexpr double kWorthRefining = 5.0;  // score below which nothing can come of it
constexpr double kWorthRefiningMore = 0.6;  // of the threshold, beside other causes
// The sharper screen is scaled to the strongest score of the other, or to this.
constexpr double kSharpest = 12.0;
constexpr double kRivalSlack = 40.0;  // screens are linear: so much worse may still be a rival

int NumParameters(const Hypothesis& hypothesis) {
  return static_cast<int>(hypothesis.fit.covariance.rows());
}

class Searcher {
 public:
  Searcher(const TrainingData& data,
           const StructureFit& baseline,
           const std::vector<Suspect>& suspects,
           const DiagnosisOptions& options)
      : data_(data), suspects_(suspects), options_(options) {
    log_num_data_ = std::log(static_cast<double>(data.bins().size()));
    result_.tried.push_back({{}, baseline, 0.0, 0.0});
    known_[{}] = 0;
    result_.scores.assign(suspects.size(), 0.0);
  }

  SearchResult Run() {
    std::vector<int> beam = {0};
    for (int size = 1; size <= options_.most_causes; ++size) {
      std::vector<int> next;
      for (const int from : beam) {
        for (const int hypothesis : Extend(from)) next.push_back(hypothesis);
      }
      if (size == 2) {
        for (const int hypothesis : Pairs()) next.push_back(hypothesis);
      }
      std::sort(next.begin(), next.end());
      next.erase(std::unique(next.begin(), next.end()), next.end());
      std::stable_sort(next.begin(), next.end(), [&](int a, int b) { return Worth(a) > Worth(b); });
      const bool better = !next.empty() && Worth(next.front()) > Worth(result_.best);
      if (better && HoldsUnderTheBaselinesNoise(next.front())) result_.best = next.front();
      if (!better && size >= 2) break;
      // What alone is no better than noise may still be half of a pair: Pairs() sees to that.
      const double most = next.empty() ? 0.0 : result_.tried[next.front()].gain;
      std::erase_if(next, [&](int index) {
        return Worth(index) <= 0.0 || result_.tried[index].gain < kLeastShare * most;
      });
      if (next.size() > kBeam) next.resize(kBeam);
      beam = std::move(next);
    }
    FindRivals();
    return std::move(result_);
  }

 private:
  // Gain less what noise would reach with the same causes.
  double Worth(int index) const {
    const Hypothesis& hypothesis = result_.tried[index];
    return hypothesis.gain - Threshold(hypothesis.suspects);
  }

  double Threshold(const std::vector<int>& suspects) const {
    double sum = 0.0;
    for (const int suspect : suspects) sum += result_.significance.Threshold(suspect);
    return sum;
  }

  // Hypotheses with one suspect more, refitted where the screen gives hope.
  std::vector<int> Extend(int from) {
    const Hypothesis base = result_.tried[from];
    const std::vector<double> best_scores = ScreenAbout(base);
    std::vector<int> order(suspects_.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(
        order.begin(), order.end(), [&](int a, int b) { return best_scores[a] > best_scores[b]; });
    std::vector<int> extended;
    int num_refined = 0;
    for (const int suspect : order) {
      const bool is_alone = base.suspects.empty();
      if (num_refined == (is_alone ? kMostRefined : kMostRefinedMore)) break;
      const double least =
          is_alone ? kWorthRefining : kWorthRefiningMore * result_.significance.Threshold(suspect);
      if (best_scores[suspect] < least) continue;
      if (std::count(base.suspects.begin(), base.suspects.end(), suspect) > 0) continue;
      ++num_refined;
      const int index = Refine(base, {suspect});
      if (index >= 0) extended.push_back(index);
    }
    return extended;
  }

  // Screens every suspect about a hypothesis under its own noise and under a sensor's alone; keeps
  // the trials. Returns the best score of each suspect, both noises on one scale.
  std::vector<double> ScreenAbout(const Hypothesis& base) {
    trials_ = TrialsAbout(data_, base.fit, suspects_);
    std::vector<double> scores(suspects_.size(), 0.0);
    starts_.assign(suspects_.size(), {});
    if (trials_.trials.empty()) return scores;
    const Whitener own(base.fit.noise, data_.bins().samples());
    const Screen screen(base.fit, &trials_, own);
    if (!is_calibrated_) Calibrate(screen);
    const Whitener sensor(SensorNoiseOnly(data_, base.fit.residual), data_.bins().samples());
    const Screen sharp(base.fit, &trials_, sensor);
    const double sharpest = *std::max_element(sharp.scores().begin(), sharp.scores().end());
    const double strongest = *std::max_element(screen.scores().begin(), screen.scores().end());
    const double scale =
        sharpest > 0.0 ? std::min(1.0, std::max(strongest, kSharpest) / sharpest) : 0.0;
    for (size_t t = 0; t < trials_.trials.size(); ++t) {
      const int suspect = trials_.trials[t].suspect;
      const double score = std::max(screen.scores()[t], scale * sharp.scores()[t]);
      scores[suspect] = std::max(scores[suspect], score);
      if (base.suspects.empty()) {
        result_.scores[suspect] = std::max(result_.scores[suspect], screen.scores()[t]);
      }
      starts_[suspect].push_back({screen.scores()[t], static_cast<int>(t), screen.amounts()[t]});
      starts_[suspect].push_back(
          {scale * sharp.scores()[t], static_cast<int>(t), sharp.amounts()[t]});
    }
    for (auto& starts : starts_) {
      std::stable_sort(starts.begin(), starts.end(), [](const Start& a, const Start& b) {
        return a.score > b.score;
      });
    }
    return scores;
  }

  void Calibrate(const Screen& screen) {
    std::vector<int> num_amounts(suspects_.size(), 1);
    for (const Trial& trial : trials_.trials) num_amounts[trial.suspect] = trial.num_columns;
    const int num_suspects = static_cast<int>(suspects_.size());
    result_.significance = Significance(screen.NullMaxima(kNullDraws, num_suspects, options_.seed),
                                        std::move(num_amounts),
                                        options_.false_alarm_rate);
    is_calibrated_ = true;
  }

  // A start for the refit: a trial and its amounts by the screen.
  struct Start {
    double score;
    int trial;
    std::vector<double> amounts;
  };

  ActiveEffect StartingEffect(int suspect, const Start& start) const {
    const Trial& trial = trials_.trials[start.trial];
    const EffectInfo& info = suspects_[suspect].effect->info();
    std::vector<double> values = trial.values;
    for (size_t k = 0; k < trial.amounts.size(); ++k) {
      const EffectParameter& parameter = info.parameters[trial.amounts[k]];
      double& value = values[trial.amounts[k]];
      if (parameter.search == Search::kAmount) {
        value = parameter.null + start.amounts[k] * (value - parameter.null);
      }
      value = std::clamp(value, parameter.lower, parameter.upper);
    }
    return {suspects_[suspect].effect, suspects_[suspect].setting, std::move(values)};
  }

  // Starts of a suspect that differ enough to lead to different optima.
  std::vector<Start> StartsOf(int suspect) const {
    std::vector<Start> chosen;
    const EffectInfo& info = suspects_[suspect].effect->info();
    const bool many = std::any_of(info.parameters.begin(),
                                  info.parameters.end(),
                                  [](const auto& p) { return p.search != Search::kAmount; });
    const size_t most = many ? 3 : 1;
    for (const Start& start : starts_[suspect]) {
      if (chosen.size() == most || (start.score <= 0.0 && !chosen.empty())) break;
      const bool is_new = std::none_of(chosen.begin(), chosen.end(), [&](const Start& other) {
        return std::abs(other.trial - start.trial) <= 1;
      });
      if (is_new) chosen.push_back(start);
    }
    return chosen;
  }

  // Fits `base` and one more suspect from each of its starts; returns the best one's index, -1 if
  // none can be simulated.
  int Refine(const Hypothesis& base, const std::vector<int>& added) {
    CHECK_EQ(added.size(), 1u);
    std::vector<int> suspects = base.suspects;
    suspects.push_back(added[0]);
    std::sort(suspects.begin(), suspects.end());
    if (const auto found = known_.find(suspects); found != known_.end()) return found->second;
    const std::vector<Start> starts = StartsOf(added[0]);
    std::optional<StructureFit> best;
    double best_chi_squared = 0.0;
    // Cheap fits under one noise from every start; the noise is learned for the best one only.
    const Whitener sensor(SensorNoiseOnly(data_, base.fit.residual), data_.bins().samples());
    for (const Start& start : starts) {
      StructureFit fit = FitStructure(data_,
                                      WithEffect(base.fit.model, StartingEffect(added[0], start)),
                                      base.fit.initial,
                                      sensor,
                                      kRough);
      if (fit.jacobian.size() == 0) continue;
      if (!best || fit.chi_squared < best_chi_squared) {
        best_chi_squared = fit.chi_squared;
        best = std::move(fit);
      }
    }
    if (!best) return -1;
    return Add(suspects, *best);
  }

  int Add(const std::vector<int>& suspects, const StructureFit& start) {
    if (const auto found = known_.find(suspects); found != known_.end()) return found->second;
    Hypothesis hypothesis;
    hypothesis.suspects = suspects;
    const NoiseModel noise = FirstNoise(data_, start);
    hypothesis.fit = FitStructureAndNoise(data_, start.model, start.initial, noise);
    const Hypothesis& baseline = result_.tried[0];
    // Worse than with less: the search went astray under the noise it began with.
    if (!(hypothesis.fit.log_likelihood > baseline.fit.log_likelihood)) {
      ExtendedModel model = start.model;
      model.baseline = baseline.fit.model.baseline;
      StructureFit again =
          FitStructureAndNoise(data_, model, baseline.fit.initial, baseline.fit.noise);
      if (again.log_likelihood > hypothesis.fit.log_likelihood) hypothesis.fit = std::move(again);
    }
    if (hypothesis.fit.jacobian.size() == 0) return -1;
    hypothesis.gain = 2.0 * (hypothesis.fit.log_likelihood - baseline.fit.log_likelihood);
    hypothesis.delta_bic =
        hypothesis.gain - log_num_data_ * (NumParameters(hypothesis) - NumParameters(baseline));
    const int index = static_cast<int>(result_.tried.size());
    known_[suspects] = index;
    result_.tried.push_back(std::move(hypothesis));
    return index;
  }

  // Pairs that only together explain much, by the linear screen about the baseline under the noise
  // of the best single suspect.
  std::vector<int> Pairs() {
    const Hypothesis base = result_.tried[0];
    ScreenAbout(base);
    if (trials_.trials.empty()) return {};
    int best_single = 0;
    for (size_t i = 1; i < result_.tried.size(); ++i) {
      if (result_.tried[i].suspects.size() == 1 &&
          result_.tried[i].gain > result_.tried[best_single].gain) {
        best_single = static_cast<int>(i);
      }
    }
    const Whitener whitener(result_.tried[best_single].fit.noise, data_.bins().samples());
    const Screen screen(base.fit, &trials_, whitener);
    // Each suspect's best trials.
    std::vector<std::vector<int>> best_trials(suspects_.size());
    for (size_t k = 0; k < suspects_.size(); ++k) {
      for (const Start& start : starts_[k]) {
        if (best_trials[k].size() == 4) break;
        if (std::count(best_trials[k].begin(), best_trials[k].end(), start.trial) == 0) {
          best_trials[k].push_back(start.trial);
        }
      }
    }
    struct Pair {
      double score;
      int a, b, trial_a, trial_b;
    };
    std::vector<Pair> pairs;
    for (size_t a = 0; a < suspects_.size(); ++a) {
      for (size_t b = a + 1; b < suspects_.size(); ++b) {
        Pair best = {0.0, static_cast<int>(a), static_cast<int>(b), -1, -1};
        for (const int trial_a : best_trials[a]) {
          for (const int trial_b : best_trials[b]) {
            const double score = screen.PairScore(trial_a, trial_b);
            if (score > best.score) best = {score, best.a, best.b, trial_a, trial_b};
          }
        }
        if (best.trial_a >= 0) pairs.push_back(best);
      }
    }
    std::stable_sort(
        pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.score > b.score; });
    std::vector<int> refined;
    constexpr size_t kMostPairs = 4;
    for (size_t i = 0; i < std::min(pairs.size(), kMostPairs); ++i) {
      const Pair& pair = pairs[i];
      if (pair.score < Threshold({pair.a, pair.b})) continue;
      const auto effect = [&](int suspect, int trial) {
        const Trial& at = trials_.trials[trial];
        return ActiveEffect{suspects_[suspect].effect, suspects_[suspect].setting, at.values};
      };
      ExtendedModel model = WithEffect(base.fit.model, effect(pair.a, pair.trial_a));
      model = WithEffect(std::move(model), effect(pair.b, pair.trial_b));
      const StructureFit fit = FitStructure(data_, model, base.fit.initial, whitener, kRough);
      if (fit.jacobian.size() == 0) continue;
      const int index = Add({pair.a, pair.b}, fit);
      if (index >= 0) refined.push_back(index);
    }
    return refined;
  }

  // A cause must hold even against a noise that was learned without it and may have swallowed it.
  bool HoldsUnderTheBaselinesNoise(int index) const {
    const Hypothesis& baseline = result_.tried[0];
    const Hypothesis& hypothesis = result_.tried[index];
    const Whitener whitener(baseline.fit.noise, data_.bins().samples());
    const StructureFit refit =
        FitStructure(data_, hypothesis.fit.model, hypothesis.fit.initial, whitener);
    constexpr double kLeast = 4.0;  // chi squared per cause
    return baseline.fit.chi_squared - refit.chi_squared >
           kLeast * static_cast<double>(hypothesis.suspects.size());
  }

  // Hypotheses with one cause replaced by another suspect that explain the data about as well.
  void FindRivals() {
    if (result_.best == 0) return;
    const std::vector<int> causes = result_.tried[result_.best].suspects;
    const NoiseModel noise = result_.tried[result_.best].fit.noise;
    for (const int cause : causes) {
      std::vector<int> others = causes;
      std::erase(others, cause);
      Hypothesis base;
      if (const auto found = known_.find(others); found != known_.end()) {
        base = result_.tried[found->second];
      } else {
        StructureFit start = result_.tried[result_.best].fit;
        const auto position = std::find(causes.begin(), causes.end(), cause) - causes.begin();
        start.model = WithoutEffect(start.model, EffectPlace(start.model, causes[position]));
        start = FitStructureAndNoise(data_, start.model, start.initial, noise);
        if (start.jacobian.size() == 0) continue;
        const int index = Add(others, start);
        if (index < 0) continue;
        base = result_.tried[index];
      }
      // Under the noise that the best hypothesis leaves, rivals stand out as they should.
      base.fit.noise = noise;
      const Whitener whitener(noise, data_.bins().samples());
      trials_ = TrialsAbout(data_, base.fit, suspects_);
      if (trials_.trials.empty()) continue;
      const Screen screen(base.fit, &trials_, whitener);
      std::vector<double> scores(suspects_.size(), 0.0);
      starts_.assign(suspects_.size(), {});
      for (size_t t = 0; t < trials_.trials.size(); ++t) {
        const int suspect = trials_.trials[t].suspect;
        scores[suspect] = std::max(scores[suspect], screen.scores()[t]);
        starts_[suspect].push_back({screen.scores()[t], static_cast<int>(t), screen.amounts()[t]});
      }
      for (auto& starts : starts_) {
        std::stable_sort(starts.begin(), starts.end(), [](const Start& a, const Start& b) {
          return a.score > b.score;
        });
      }
      std::vector<int> order(suspects_.size());
      std::iota(order.begin(), order.end(), 0);
      std::stable_sort(
          order.begin(), order.end(), [&](int a, int b) { return scores[a] > scores[b]; });
      int num_refined = 0;
      for (const int suspect : order) {
        const bool is_worse = scores[suspect] < 0.6 * scores[cause] - kRivalSlack;
        if (is_worse || scores[suspect] <= 0.0 || num_refined == kMostRefined) break;
        if (std::count(causes.begin(), causes.end(), suspect) > 0) continue;
        ++num_refined;
        Refine(base, {suspect});
      }
    }
    PreferTheBest(causes);
    CollectRivals();
  }

  // Refined rivals may turn out better than what was thought best.
  void PreferTheBest(const std::vector<int>& causes) {
    for (size_t i = 0; i < result_.tried.size(); ++i) {
      const Hypothesis& other = result_.tried[i];
      if (other.suspects.size() != causes.size()) continue;
      if (other.delta_bic > result_.tried[result_.best].delta_bic + 1e-9) {
        result_.best = static_cast<int>(i);
      }
    }
  }

  void CollectRivals() {
    const Hypothesis& best = result_.tried[result_.best];
    for (size_t i = 0; i < result_.tried.size(); ++i) {
      const Hypothesis& other = result_.tried[i];
      if (static_cast<int>(i) == result_.best || other.suspects.size() != best.suspects.size()) {
        continue;
      }
      std::vector<int> shared;
      std::set_intersection(best.suspects.begin(),
                            best.suspects.end(),
                            other.suspects.begin(),
                            other.suspects.end(),
                            std::back_inserter(shared));
      if (shared.size() + 1 != best.suspects.size()) continue;
      if (best.delta_bic - other.delta_bic < options_.separation) {
        result_.rivals.push_back(static_cast<int>(i));
      }
    }
  }

  int EffectPlace(const ExtendedModel& model, int suspect) const {
    for (size_t k = 0; k < model.effects.size(); ++k) {
      if (model.effects[k].effect == suspects_[suspect].effect &&
          model.effects[k].setting.partner == suspects_[suspect].setting.partner) {
        return static_cast<int>(k);
      }
    }
    LOG(FATAL) << "A hypothesis has the effects of its suspects.";
    return -1;
  }

  const TrainingData& data_;
  const std::vector<Suspect>& suspects_;
  const DiagnosisOptions& options_;
  double log_num_data_ = 1.0;  // of bins
  bool is_calibrated_ = false;
  SearchResult result_;
  std::map<std::vector<int>, int> known_;  // index into result_.tried

  // Of the last screen.
  Trials trials_;
  std::vector<std::vector<Start>> starts_;  // by suspect, best first
};

}  // namespace

SearchResult SearchCauses(const TrainingData& data,
                          const StructureFit& baseline,
                          const std::vector<Suspect>& suspects,
                          const DiagnosisOptions& options) {
  return Searcher(data, baseline, suspects, options).Run();
}

}  // namespace fathom
