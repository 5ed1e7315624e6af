// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/search/refinement.h"

#include "fathom/base/parallel_for.h"
#include "fathom/diagnosis/fit/fit_with_noise.h"
#include "fathom/diagnosis/fit/preparation.h"
#include "fathom/diagnosis/fit/start_price.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace fathom {
namespace {

int NumParameters(const Hypothesis& hypothesis) {
  return static_cast<int>(hypothesis.fit.covariance.rows());
}

bool MeansSomething(const SearchTask& task, const Hypothesis& baseline, const StructureFit& fit) {
  if (!fit.IsUsable() || fit.is_on_bound[kInertia]) return false;
  const double inertia_before = baseline.fit.model.baseline.inertia;
  if (fit.model.baseline.inertia > kRunAway * inertia_before) return false;
  const double std = std::sqrt(fit.covariance(kInertia, kInertia));
  if (!(std < task.options.open_inertia * fit.model.baseline.inertia)) return false;
  const auto& effects = fit.model.effects;
  return std::none_of(effects.begin(), effects.end(), [&](const ActiveEffect& active) {
    return IsAtTheCommandsTone(task.data, active.effect->info(), active.values);
  });
}

// The best of the cheap fits of `base` and one suspect more under one screen's noise.
std::optional<StructureFit> RoughFit(const SearchTask& task,
                                     const Starts& starts,
                                     const Hypothesis& base,
                                     int suspect) {
  const auto& parameters = task.suspects[suspect].effect->info().parameters;
  const bool amounts_alone = std::all_of(parameters.begin(), parameters.end(), [](const auto& p) {
    return p.search == Search::kAmount;
  });
  std::optional<StructureFit> best;
  for (const Start& start : starts.Of(suspect, amounts_alone ? 1 : task.options.most_starts)) {
    StructureFit fit = FitStructure(task.data,
                                    WithEffect(base.fit.model, start.effect),
                                    base.fit.initial,
                                    starts.whitener(),
                                    task.options.rough);
    if (!fit.IsSimulated()) continue;
    if (!best || fit.chi_squared < best->chi_squared) best = std::move(fit);
  }
  return best;
}

// Whether a suspect shows beside `base` where `known`, which has both, does not have it.
bool ShowsElsewhere(const SearchTask& task,
                    const Starts& own,
                    const Hypothesis& base,
                    int suspect,
                    const Hypothesis& known) {
  if (own.Score(suspect) < known.gain - base.gain + task.options.worth_refining) return false;
  const std::vector<Start> starts = own.Of(suspect, 1);
  if (starts.empty()) return false;
  const ExtendedModel& model = known.fit.model;
  const ActiveEffect& effect = model.effects[EffectPlace(task, model, suspect)];
  return IsElsewhere(effect, starts.front().effect, task.data.longest_duration());
}

// Whether the sharper screen shows a suspect at another time or frequency.
bool ShowsElsewhereOnTheSharper(const SearchTask& task, const Screens& screens, int suspect) {
  if (screens.own->TrialsOf(suspect).empty()) return false;
  return IsElsewhere(screens.own->BestTrialOf(suspect),
                     screens.sharp->BestTrialOf(suspect),
                     task.data.longest_duration());
}

// True if two rough fits differ by less than the noise lets one see, or than how near to their ends
// they are.
bool AreAlike(const SearchTask& task,
              const Whitener& whitener,
              const StructureFit& a,
              const StructureFit& b) {
  Eigen::VectorXd difference = a.residual - b.residual;
  const std::span<double> values(difference.data(), difference.size());
  whitener.Apply(values, values);
  const double off = 2.0 * task.options.rough.share * std::min(a.chi_squared, b.chi_squared);
  return difference.squaredNorm() < std::max(task.options.alike, off);
}

std::vector<int> With(std::vector<int> suspects, int more) {
  suspects.push_back(more);
  std::sort(suspects.begin(), suspects.end());
  return suspects;
}

// A fit that gains less than its share of `most_gain` is left where its first noise leaves it.
FitPrecision PrecisionFor(const SearchTask& task, const Hypothesis& baseline, double most_gain) {
  FitPrecision precision = task.options.precision;
  precision.least = baseline.fit.log_likelihood +
                    0.5 * task.options.hope * most_gain / task.options.effective_share;
  return precision;
}

// The hypothesis with its noise learned from nothing, as the baseline's was: what is worth its
// price may rest on a noise that was begun wrongly, on either side.
Hypothesis Settled(const SearchTask& task,
                   const Hypothesis& baseline,
                   Hypothesis begun,
                   double most_gain) {
  const FitPrecision precision = PrecisionFor(task, baseline, most_gain);
  StructureFit fit = FitStructureAndNoise(task.data, begun.fit, precision);
  // Worse than with less: the search went astray.
  if (!(fit.log_likelihood > baseline.fit.log_likelihood)) return begun;
  begun.fit = std::move(fit);
  return Weighed(task, baseline, std::move(begun));
}

// The greatest gain of what stands without one of some suspects.
double GainWithoutOne(const HypothesisBook& book, const std::vector<int>& suspects) {
  double most = 0.0;
  for (const int suspect : suspects) {
    const int index = book.IndexOf(Without(suspects, suspect));
    if (index >= 0) most = std::max(most, book[index].gain);
  }
  return most;
}

// Whether a hypothesis may lead, so that it is settled.
bool Contends(const SearchTask& task,
              const HypothesisBook& book,
              const Hypothesis& begun,
              double most_gain) {
  const double gain = 2.0 * (begun.fit.log_likelihood - book.baseline().fit.log_likelihood);
  return task.options.criterion == Criterion::kLearnedNoise &&
         gain > GainWithoutOne(book, begun.suspects) + task.options.worth_refining &&
         gain > task.options.contends * most_gain;
}

}  // namespace

Hypothesis Weighed(const SearchTask& task, const Hypothesis& baseline, Hypothesis hypothesis) {
  const double share = task.options.effective_share;
  const double log_num_data = std::log(share * static_cast<double>(task.data.bins().size()));
  hypothesis.gain = share * 2.0 * (hypothesis.fit.log_likelihood - baseline.fit.log_likelihood) -
                    PriceOfStarts(task.data, hypothesis.fit.start_gains);
  hypothesis.delta_bic =
      hypothesis.gain - log_num_data * (NumParameters(hypothesis) - NumParameters(baseline));
  return hypothesis;
}

Hypothesis BegunFrom(const SearchTask& task,
                     const Hypothesis& baseline,
                     const Hypothesis& base,
                     std::vector<int> suspects,
                     const StructureFit& rough,
                     double most_gain) {
  Hypothesis hypothesis;
  hypothesis.suspects = std::move(suspects);
  const Criterion criterion = task.options.criterion;
  const FitPrecision precision = PrecisionFor(task, baseline, most_gain);
  std::vector<NoiseModel> known = {baseline.fit.noise};
  if (!base.suspects.empty()) known.push_back(base.fit.noise);
  hypothesis.fit = FitBy(criterion, task.data, rough, known, precision);
  // Worse than with less: the search went astray under the noise it began with.
  if (!(hypothesis.fit.log_likelihood > baseline.fit.log_likelihood)) {
    ExtendedModel model = rough.model;
    model.baseline = baseline.fit.model.baseline;
    StructureFit again =
        FitBy(criterion, task.data, model, baseline.fit.initial, baseline.fit.noise, precision);
    if (again.log_likelihood > hypothesis.fit.log_likelihood) hypothesis.fit = std::move(again);
  }
  return Weighed(task, baseline, std::move(hypothesis));
}

HypothesisBook WithSettled(const SearchTask& task,
                           std::vector<Hypothesis> begun,
                           double most_gain,
                           HypothesisBook book) {
  for (const Hypothesis& hypothesis : begun) {
    if (MeansSomething(task, book.baseline(), hypothesis.fit))
      most_gain = std::max(most_gain, hypothesis.gain);
  }
  ParallelFor(static_cast<int>(begun.size()), [&](int i) {
    if (!Contends(task, book, begun[i], most_gain)) return;
    begun[i] = Settled(task, book.baseline(), std::move(begun[i]), most_gain);
  });
  for (Hypothesis& hypothesis : begun) {
    if (MeansSomething(task, book.baseline(), hypothesis.fit)) book.Add(std::move(hypothesis));
  }
  return book;
}

namespace {

double MostGainOfSize(const HypothesisBook& book, std::size_t size) {
  double most = 0.0;
  for (int i = 0; i < book.size(); ++i) {
    if (book[i].suspects.size() == size) most = std::max(most, book[i].gain);
  }
  return most;
}

// The greatest gains so far: of all, of hypotheses as large as the ones that are made, and of their
// scores (far above 1 where `base` is no model of these data).
struct MostSoFar {
  double gain, gain_of_size, kept = 1.0;
};

// Whether `base` and one suspect more would not count even if it gained twice as much of its score
// as any before it: one cause alone is worth a look if others may be added to it, several if they
// lead.
bool IsHopeless(const SearchTask& task,
                const Screens& screens,
                const Hypothesis& base,
                int suspect,
                const MostSoFar& most) {
  const SearchOptions& options = task.options;
  const double share = base.suspects.empty() ? options.least_share : 1.0;
  return base.gain + options.optimism * most.kept * screens.scores[suspect] <
         share * most.gain_of_size;
}

// `base` and one suspect more, from where the screens show it best; nothing where that is known.
std::vector<Hypothesis> HypothesesWith(const SearchTask& task,
                                       const Screens& screens,
                                       const Hypothesis& base,
                                       int suspect,
                                       const HypothesisBook& book,
                                       const MostSoFar& most) {
  const std::vector<int> suspects = With(base.suspects, suspect);
  if (IsHopeless(task, screens, base, suspect, most)) return {};
  const int known = book.IndexOf(suspects);
  if (known >= 0 && !ShowsElsewhere(task, *screens.own, base, suspect, book[known])) return {};
  std::vector<Hypothesis> hypotheses;
  const auto add = [&](const StructureFit& rough) {
    hypotheses.push_back(BegunFrom(task, book.baseline(), base, suspects, rough, most.gain));
  };
  const auto own = RoughFit(task, *screens.own, base, suspect);
  if (own) add(*own);
  if (!screens.sharp) return hypotheses;
  // One that gains less than the screens promised went astray, or its noise has swallowed it.
  const double promised = base.gain + task.options.kept * screens.scores[suspect];
  const bool is_kept = !hypotheses.empty() && hypotheses.front().gain > promised;
  if (is_kept && !ShowsElsewhereOnTheSharper(task, screens, suspect)) return hypotheses;
  const auto sharp = RoughFit(task, *screens.sharp, base, suspect);
  if (sharp && !(own && AreAlike(task, screens.own->whitener(), *own, *sharp))) add(*sharp);
  return hypotheses;
}

}  // namespace

HypothesisBook Refined(const SearchTask& task,
                       const Screens& screens,
                       const Hypothesis& base,
                       std::span<const int> suspects,
                       HypothesisBook book) {
  // Those of one group do not know of each other's gains, whatever the number of threads.
  constexpr std::size_t kGroup = 4;
  MostSoFar most = {book.MostGain(), MostGainOfSize(book, base.suspects.size() + 1)};
  std::vector<Hypothesis> begun;
  for (std::size_t begin = 0; begin < suspects.size() && !task.IsSpent(); begin += kGroup) {
    const auto group = suspects.subspan(begin, std::min(kGroup, suspects.size() - begin));
    std::vector<std::vector<Hypothesis>> found(group.size());
    ParallelFor(static_cast<int>(group.size()), [&](int i) {
      found[i] = HypothesesWith(task, screens, base, group[i], book, most);
    });
    for (std::size_t i = 0; i < group.size(); ++i) {
      book.AddAttempt(With(base.suspects, group[i]));
      for (Hypothesis& hypothesis : found[i]) {
        if (MeansSomething(task, book.baseline(), hypothesis.fit)) {
          most.gain = std::max(most.gain, hypothesis.gain);
          most.gain_of_size = std::max(most.gain_of_size, hypothesis.gain);
          most.kept = std::max(most.kept, (hypothesis.gain - base.gain) / screens.scores[group[i]]);
        }
        begun.push_back(std::move(hypothesis));
      }
    }
  }
  return WithSettled(task, std::move(begun), book.MostGain(), std::move(book));
}

}  // namespace fathom
