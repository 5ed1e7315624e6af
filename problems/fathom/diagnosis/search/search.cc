// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/search/search.h"

#include "fathom/diagnosis/search/starts.h"
#include "fathom/diagnosis/search/suspects.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include <glog/logging.h>

namespace fathom {
namespace {

constexpr int kNullDraws = 512;
constexpr int kBeam = 3;             // hypotheses that are carried on from each size
constexpr int kMostRefined = 10;     // suspects refitted about one hypothesis
constexpr int kMostRefinedMore = 4;  // and about one with causes
constexpr double kRough = 1e-3;      // share of the error at which a first fit is near enough
// Of the best one's gain, below which one cause, or several, are not carried on.
constexpr double kLeastShare = 0.3, kLeastShareOfSeveral = 0.7;
constexpr double kWorthRefining = 5.0;      // score below which nothing can come of it
constexpr double kWorthRefiningMore = 0.6;  // of the threshold, beside other causes
// The sharper screen is scaled to the strongest score of the other, or to this.
constexpr double kSharpest = 12.0;
// The draws know the noise. A fit learns it along, and finds more than they do: how much more is
// measured on logs with nothing hidden, docs/diagnosis.md (7).
constexpr double kCautionOfLearnedNoise = 8.0;
// A fit finds the best time or frequency, not the best of the grid.
constexpr double kCautionBetweenTheGrid = 2.0;
// Another axis' columns are in every log, whether they have to do with this axis or not.
constexpr double kCautionWithAPartner = 50.0;
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
    result_.failed_alone.assign(suspects.size(), false);
  }

  SearchResult Run() {
    std::vector<int> beam = {0};
    for (int size = 1; size <= options_.most_causes; ++size) {
      for (const int from : beam) Extend(from);
      if (size == 2) RefinePairs();
      const std::vector<int> ranked = RankedOfSize(size);
      const bool better = !ranked.empty() && Worth(ranked.front()) > Worth(result_.best);
      if (better && HoldsUnderTheBaselinesNoise(ranked.front())) {
        result_.best = ranked.front();
        Challenge();
      }
      if (!better && size >= 2) break;
      beam = CarriedOn(size);
    }
    result_.rivals = FindRivals(data_, result_, options_.separation);
    return std::move(result_);
  }

 private:
  // Hypotheses of so many causes, the best first.
  std::vector<int> RankedOfSize(int size) const {
    std::vector<int> ranked;
    for (size_t i = 0; i < result_.tried.size(); ++i) {
      if (static_cast<int>(result_.tried[i].suspects.size()) == size) {
        ranked.push_back(static_cast<int>(i));
      }
    }
    std::stable_sort(
        ranked.begin(), ranked.end(), [&](int a, int b) { return Worth(a) > Worth(b); });
    return ranked;
  }

  // Those of them that one more cause may be added to. What alone is no better than noise may still
  // be half of a pair: RefinePairs() sees to that.
  std::vector<int> CarriedOn(int size) const {
    std::vector<int> beam = RankedOfSize(size);
    const double most = beam.empty() ? 0.0 : result_.tried[beam.front()].gain;
    const double least = (size == 1 ? kLeastShare : kLeastShareOfSeveral) * most;
    std::erase_if(
        beam, [&](int index) { return Worth(index) <= 0.0 || result_.tried[index].gain < least; });
    if (beam.size() > kBeam) beam.resize(kBeam);
    return beam;
  }

  // Gain less what noise would reach with the same causes.
  double Worth(int index) const {
    const Hypothesis& hypothesis = result_.tried[index];
    if (!IsPhysical(hypothesis)) return -std::numeric_limits<double>::infinity();
    return hypothesis.gain - Threshold(hypothesis.suspects);
  }

  double Threshold(const std::vector<int>& suspects) const {
    return ThresholdOf(result_, suspects);
  }

  // Refits `from` with one suspect more, where the screens give hope.
  void Extend(int from) {
    const Hypothesis base = result_.tried[from];
    ScreenAbout(from, base.fit.noise, true);
    const bool is_alone = base.suspects.empty();
    if (is_alone && own_) {
      if (!is_calibrated_) Calibrate(own_->screen());
      for (size_t k = 0; k < suspects_.size(); ++k) {
        result_.scores[k] = std::max(result_.scores[k], own_->Score(static_cast<int>(k)));
      }
    }
    const std::vector<double> scores = Scores();
    int num_refined = 0;
    for (const int suspect : InOrder(scores)) {
      if (num_refined == (is_alone ? kMostRefined : kMostRefinedMore)) break;
      const double least = is_alone
                               ? kWorthRefining
                               : kWorthRefiningMore * result_.significance.ThresholdBeside(suspect);
      if (scores[suspect] < least || Has(base, suspect)) continue;
      ++num_refined;
      if (!HoldsTheBest(base, suspect)) Refine(base, suspect);
    }
  }

  // True if a hypothesis and one suspect more hold all of the best one's causes and others: these
  // are looked for about the best one itself.
  bool HoldsTheBest(const Hypothesis& base, int suspect) const {
    const std::vector<int>& causes = result_.tried[result_.best].suspects;
    return !causes.empty() && causes.size() <= base.suspects.size() && base.suspects != causes &&
           std::all_of(causes.begin(), causes.end(), [&](int cause) {
             return cause == suspect || Has(base, cause);
           });
  }

  static bool Has(const Hypothesis& hypothesis, int suspect) {
    return std::count(hypothesis.suspects.begin(), hypothesis.suspects.end(), suspect) > 0;
  }

  // Screens every suspect about a hypothesis, under a noise and, if asked, under a sensor's alone:
  // there nothing that is missing passes for a disturbance.
  void ScreenAbout(int about, const NoiseModel& noise, bool with_sensor) {
    own_.reset();
    sharp_.reset();
    std::optional<Trials>& trials = about == 0 ? baseline_trials_ : other_trials_;
    screened_ = result_.tried[about].fit;
    // The baseline's fit is never another, and most of a screen is simulation.
    if (about != 0 || !trials) trials = TrialsAbout(data_, screened_, suspects_);
    trials_ = &*trials;
    if (trials_->trials.empty()) return;
    own_.emplace(data_, screened_, suspects_, *trials_, Whitener(noise, data_.samples()));
    if (!with_sensor) return;
    sharp_.emplace(data_,
                   screened_,
                   suspects_,
                   *trials_,
                   Whitener(SensorNoiseOnly(data_, screened_.residual), data_.samples()));
  }

  // Best score of each suspect on the last screens, the sharper one scaled to the other.
  std::vector<double> Scores() const {
    std::vector<double> scores(suspects_.size(), 0.0);
    if (!own_) return scores;
    const double sharpest = sharp_ ? sharp_->BestScore() : 0.0;
    const double scale =
        sharpest > 0.0 ? std::min(1.0, std::max(own_->BestScore(), kSharpest) / sharpest) : 0.0;
    for (size_t k = 0; k < scores.size(); ++k) {
      const int suspect = static_cast<int>(k);
      scores[k] = own_->Score(suspect);
      if (sharp_) scores[k] = std::max(scores[k], scale * sharp_->Score(suspect));
    }
    return scores;
  }

  static std::vector<int> InOrder(const std::vector<double>& scores) {
    std::vector<int> order(scores.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(
        order.begin(), order.end(), [&](int a, int b) { return scores[a] > scores[b]; });
    return order;
  }

  void Calibrate(const Screen& screen) {
    std::vector<int> num_amounts(suspects_.size(), 1);
    std::vector<double> caution(suspects_.size(), 1.0);
    for (const Trial& trial : trials_->trials) {
      num_amounts[trial.suspect] = trial.num_columns;
      const bool is_searched = trial.values.size() > trial.amounts.size();
      const bool has_partner = suspects_[trial.suspect].effect->info().has_partner();
      caution[trial.suspect] = kCautionOfLearnedNoise *
                               (is_searched ? kCautionBetweenTheGrid : 1.0) *
                               (has_partner ? kCautionWithAPartner : 1.0);
    }
    const int num_suspects = static_cast<int>(suspects_.size());
    result_.significance = Significance(screen.NullMaxima(kNullDraws, num_suspects, options_.seed),
                                        std::move(num_amounts),
                                        caution,
                                        options_.false_alarm_rate);
    is_calibrated_ = true;
    for (int k = 0; k < num_suspects; ++k) {
      // Its parameters must be paid for as well.
      const double paid =
          log_num_data_ * static_cast<double>(suspects_[k].effect->info().parameters.size());
      const Significance& significance = result_.significance;
      result_.thresholds.push_back(std::max(significance.Threshold(k), paid));
      result_.thresholds_beside.push_back(std::max(significance.ThresholdBeside(k), paid));
    }
  }

  // The best of the cheap fits of `base` and one suspect more under one screen's noise.
  std::optional<StructureFit> RoughFit(const Hypothesis& base,
                                       int suspect,
                                       const Starts& starts) const {
    const auto& parameters = suspects_[suspect].effect->info().parameters;
    const bool many = std::any_of(parameters.begin(), parameters.end(), [](const auto& p) {
      return p.search != Search::kAmount;
    });
    std::optional<StructureFit> best;
    for (const Start& start : starts.Of(suspect, many ? 2 : 1)) {
      StructureFit fit = FitStructure(data_,
                                      WithEffect(base.fit.model, start.effect),
                                      base.fit.initial,
                                      starts.whitener(),
                                      kRough);
      if (fit.jacobian.size() == 0) continue;
      if (!best || fit.chi_squared < best->chi_squared) best = std::move(fit);
    }
    return best;
  }

  // Fits `base` and one more suspect, from where each of the last screens shows it best; the noise
  // is learned for these only. If that was done before, only where it now shows elsewhere.
  void Refine(const Hypothesis& base, int suspect) {
    std::vector<int> suspects = base.suspects;
    suspects.push_back(suspect);
    std::sort(suspects.begin(), suspects.end());
    if (const auto found = known_.find(suspects); found != known_.end()) {
      if (!ShowsElsewhere(base, suspect, result_.tried[found->second])) return;
    }
    std::optional<StructureFit> sharp, own = RoughFit(base, suspect, *own_);
    if (sharp_) sharp = RoughFit(base, suspect, *sharp_);
    if (sharp) Add(suspects, *sharp);
    if (own && !(sharp && AreAlike(*own, *sharp))) Add(suspects, *own);
    if (base.suspects.empty()) result_.failed_alone[suspect] = !known_.contains(suspects);
  }

  bool ShowsElsewhere(const Hypothesis& base, int suspect, const Hypothesis& known) const {
    if (own_->Score(suspect) < known.gain - base.gain + kWorthRefining) return false;
    const std::vector<Start> starts = own_->Of(suspect, 1);
    if (starts.empty()) return false;
    const ActiveEffect& effect = known.fit.model.effects[EffectPlace(known.fit.model, suspect)];
    return IsElsewhere(effect, starts.front().effect, data_.longest_duration());
  }

  // True if two fits differ by less than the noise lets one see.
  bool AreAlike(const StructureFit& a, const StructureFit& b) const {
    Eigen::VectorXd difference = a.residual - b.residual;
    const std::span<double> values(difference.data(), difference.size());
    own_->whitener().Apply(values, values);
    return difference.squaredNorm() < 0.1;
  }

  // False for a fit that cannot be simulated, that leaves the inertia open, or that has a tone
  // where the command has its own.
  bool MeansSomething(const StructureFit& fit) const {
    if (fit.jacobian.size() == 0 || fit.is_on_bound[kInertia]) return false;
    if (!(std::sqrt(fit.covariance(kInertia, kInertia)) < 3.0 * fit.model.baseline.inertia)) {
      return false;
    }
    return std::none_of(
        fit.model.effects.begin(), fit.model.effects.end(), [&](const ActiveEffect& active) {
          return IsAtTheCommandsTone(data_, active.effect->info(), active.values);
        });
  }

  // Learns the noise of a hypothesis from a rough fit. Of two fits of the same causes the better
  // one is kept. Returns its index, -1 if it cannot be simulated.
  int Add(const std::vector<int>& suspects, const StructureFit& start) {
    const Hypothesis& baseline = result_.tried[0];
    Hypothesis hypothesis;
    hypothesis.suspects = suspects;
    hypothesis.fit = FitStructureAndNoise(data_, start);
    // Worse than with less: the search went astray under the noise it began with.
    if (!(hypothesis.fit.log_likelihood > baseline.fit.log_likelihood)) {
      ExtendedModel model = start.model;
      model.baseline = baseline.fit.model.baseline;
      StructureFit again =
          FitStructureAndNoise(data_, model, baseline.fit.initial, baseline.fit.noise);
      if (again.log_likelihood > hypothesis.fit.log_likelihood) hypothesis.fit = std::move(again);
    }
    const auto found = known_.find(suspects);
    if (!MeansSomething(hypothesis.fit)) return found == known_.end() ? -1 : found->second;
    hypothesis.gain = 2.0 * (hypothesis.fit.log_likelihood - baseline.fit.log_likelihood) -
                      PriceOfStarts(data_, hypothesis.fit);
    hypothesis.delta_bic =
        hypothesis.gain - log_num_data_ * (NumParameters(hypothesis) - NumParameters(baseline));
    if (found == known_.end()) {
      known_[suspects] = static_cast<int>(result_.tried.size());
      result_.tried.push_back(std::move(hypothesis));
      return known_[suspects];
    }
    if (hypothesis.gain > result_.tried[found->second].gain) {
      result_.tried[found->second] = std::move(hypothesis);
    }
    return found->second;
  }

  // Refits the pairs that only together explain much, by the linear screen about the baseline under
  // the noise of the best single suspect.
  void RefinePairs() {
    const Hypothesis base = result_.tried[0];
    int best_single = 0;
    for (const int index : RankedOfSize(1)) {
      if (result_.tried[index].gain > result_.tried[best_single].gain) best_single = index;
    }
    ScreenAbout(0, result_.tried[best_single].fit.noise, true);
    if (!own_) return;
    const Screen& screen = own_->screen();
    const Whitener& whitener = own_->whitener();
    // Each suspect's best trials on either screen.
    std::vector<std::vector<int>> best_trials(suspects_.size());
    for (size_t k = 0; k < suspects_.size(); ++k) {
      for (const Starts* starts : {&*own_, &*sharp_}) {
        const auto& own = starts->TrialsOf(static_cast<int>(k));
        const auto count = std::min<size_t>(own.size(), 2);
        best_trials[k].insert(best_trials[k].end(), own.begin(), own.begin() + count);
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
    constexpr size_t kMostPairs = 4;
    for (size_t i = 0; i < std::min(pairs.size(), kMostPairs); ++i) {
      const Pair& pair = pairs[i];
      if (pair.score < Threshold({pair.a, pair.b})) continue;
      const auto effect = [&](int suspect, int trial) {
        const Trial& at = trials_->trials[trial];
        return ActiveEffect{suspects_[suspect].effect, suspects_[suspect].setting, at.values};
      };
      ExtendedModel model = WithEffect(base.fit.model, effect(pair.a, pair.trial_a));
      model = WithEffect(std::move(model), effect(pair.b, pair.trial_b));
      const StructureFit fit = FitStructure(data_, model, base.fit.initial, whitener, kRough);
      if (fit.jacobian.size() == 0) continue;
      Add({pair.a, pair.b}, fit);
    }
  }

  // A cause must hold even against a noise that was learned without it and may have swallowed it.
  bool HoldsUnderTheBaselinesNoise(int index) const {
    const Hypothesis& baseline = result_.tried[0];
    const Hypothesis& hypothesis = result_.tried[index];
    const Whitener whitener(baseline.fit.noise, data_.samples());
    const StructureFit refit =
        FitStructure(data_, hypothesis.fit.model, hypothesis.fit.initial, whitener);
    constexpr double kLeast = 4.0;  // chi squared per cause
    return baseline.fit.chi_squared - refit.chi_squared >
           kLeast * static_cast<double>(hypothesis.suspects.size());
  }

  // Tries the best hypothesis with each cause left out and with each replaced, until none of these
  // is better.
  void Challenge() {
    constexpr int kMostRounds = 3;
    for (int round = 0; round < kMostRounds; ++round) {
      const int challenged = result_.best;
      const std::vector<int> causes = result_.tried[challenged].suspects;
      for (const int cause : causes) ReplaceCause(challenged, cause);
      for (const int size :
           {static_cast<int>(causes.size()) - 1, static_cast<int>(causes.size())}) {
        if (size == 0) continue;
        const int first = RankedOfSize(size).front();
        if (Worth(first) > Worth(result_.best) + 1e-9) result_.best = first;
      }
      if (result_.best == challenged) return;
    }
  }

  // Refits a hypothesis without one cause, and with what may stand in for it.
  void ReplaceCause(int challenged, int cause) {
    const StructureFit fit = result_.tried[challenged].fit;
    std::vector<int> others = result_.tried[challenged].suspects;
    std::erase(others, cause);
    int without = 0;
    if (!others.empty()) {
      ExtendedModel model = WithoutEffect(fit.model, EffectPlace(fit.model, cause));
      const StructureFit start =
          FitStructure(data_, model, fit.initial, Whitener(fit.noise, data_.samples()), kRough);
      without = start.jacobian.size() == 0 ? -1 : Add(others, start);
    }
    if (without < 0) return;
    const Hypothesis base = result_.tried[without];
    // Under the noise that the challenged one leaves, rivals stand out as they should.
    ScreenAbout(without, fit.noise, false);
    if (!own_) return;
    const std::vector<double> scores = Scores();
    int num_refined = 0;
    for (const int suspect : InOrder(scores)) {
      const bool is_worse = scores[suspect] < 0.6 * scores[cause] - kRivalSlack;
      if (is_worse || scores[suspect] < kWorthRefining || num_refined == kMostRefined) break;
      if (Has(result_.tried[challenged], suspect)) continue;
      ++num_refined;
      Refine(base, suspect);
    }
  }

  int EffectPlace(const ExtendedModel& model, int suspect) const {
    const int place = PlaceIn(model, suspects_[suspect]);
    CHECK_GE(place, 0) << "A hypothesis has the effects of its suspects.";
    return place;
  }

  const TrainingData& data_;
  const std::vector<Suspect>& suspects_;
  const DiagnosisOptions& options_;
  double log_num_data_ = 1.0;  // of bins
  bool is_calibrated_ = false;
  SearchResult result_;
  std::map<std::vector<int>, int> known_;  // index into result_.tried

  // The last screens, and what they are about.
  StructureFit screened_;
  std::optional<Trials> baseline_trials_, other_trials_;
  const Trials* trials_ = nullptr;
  std::optional<Starts> own_;    // under the noise of a fit
  std::optional<Starts> sharp_;  // under a sensor's noise alone
};

}  // namespace

SearchResult SearchCauses(const TrainingData& data,
                          const StructureFit& baseline,
                          const std::vector<Suspect>& suspects,
                          const DiagnosisOptions& options) {
  return Searcher(data, baseline, suspects, options).Run();
}

}  // namespace fathom
