// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/search/search.h"

#include "fathom/base/parallel_for.h"
#include "fathom/diagnosis/fit/fit_with_noise.h"
#include "fathom/diagnosis/search/momentum_starts.h"
#include "fathom/diagnosis/search/pairs.h"
#include "fathom/diagnosis/search/refinement.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace fathom {
namespace {

// Hypotheses of so many causes that one more may be added to. What alone is no better than noise
// may still be half of a pair: WithPairs() sees to that.
std::vector<int> CarriedOn(const SearchTask& task, const HypothesisBook& book, int size) {
  const SearchOptions& options = task.options;
  std::vector<int> beam = book.RankedOfSize(size);
  const double most = beam.empty() ? 0.0 : book[beam.front()].gain;
  const double least = (size == 1 ? options.least_share : options.least_share_of_several) * most;
  std::erase_if(beam,
                [&](int index) { return book.Worth(index) <= 0.0 || book[index].gain < least; });
  if (beam.size() > static_cast<size_t>(options.beam)) beam.resize(options.beam);
  return beam;
}

// True if a hypothesis and one suspect more hold all of the best one's causes and others: these are
// looked for about the best one itself.
bool HoldsTheBest(const Hypothesis& best, const Hypothesis& base, int suspect) {
  const std::vector<int>& causes = best.suspects;
  return !causes.empty() && causes.size() <= base.suspects.size() && base.suspects != causes &&
         std::all_of(causes.begin(), causes.end(), [&](int cause) {
           return cause == suspect || base.Has(cause);
         });
}

// The book with the baseline and one suspect more, where the screens give hope.
HypothesisBook WithSingles(const SearchTask& task, const Screens& screens, HypothesisBook book) {
  const Hypothesis baseline = book.baseline();
  std::vector<int> suspects;
  for (const int suspect : InOrder(screens.scores)) {
    if (std::ssize(suspects) == task.options.most_refined) break;
    if (screens.scores[suspect] < task.options.worth_refining) break;
    suspects.push_back(suspect);
  }
  return Refined(task, screens, baseline, suspects, std::move(book));
}

struct Widened {
  HypothesisBook book;
  bool shows = false;  // whether anything showed beside the hypothesis
};

// The same with a hypothesis that has causes.
Widened WithOneMore(const SearchTask& task, int from, HypothesisBook book) {
  const Hypothesis base = book[from];
  const Screens screens =
      ScreensAbout(task, WithTrials(task, base.fit), base.fit.noise, Sharpness::kWithSensor);
  if (!screens.own) return {std::move(book)};
  std::vector<int> suspects;
  int num_shown = 0;
  for (const int suspect : InOrder(screens.scores)) {
    if (num_shown == task.options.most_refined_beside) break;
    const double least = task.options.worth_refining_beside *
                         book.calibration().significance.ThresholdBeside(suspect);
    if (screens.scores[suspect] < least || base.Has(suspect)) continue;
    ++num_shown;
    if (!HoldsTheBest(book[book.best()], base, suspect)) suspects.push_back(suspect);
  }
  return {Refined(task, screens, base, suspects, std::move(book)), num_shown > 0};
}

// The book with one suspect more beside each of some hypotheses, the best first. Where nothing
// shows beside that one, nothing is left for others to explain together.
HypothesisBook WithOneMoreEach(const SearchTask& task,
                               const std::vector<int>& beam,
                               HypothesisBook book) {
  for (const int from : beam) {
    if (task.IsSpent()) break;
    Widened widened = WithOneMore(task, from, std::move(book));
    book = std::move(widened.book);
    if (from == beam.front() && !widened.shows) break;
  }
  return book;
}

// A cause must hold even against a noise that was learned without it and may have swallowed it,
// unless it gains several times what noise alone reaches, over what stands.
bool HoldsUnderTheBaselinesNoise(const SearchTask& task,
                                 const HypothesisBook& book,
                                 const Hypothesis& hypothesis) {
  const Hypothesis& standing = book[book.best()];
  if (task.options.criterion == Criterion::kFreeRun) return true;
  const auto threshold = [&](const Hypothesis& of) {
    return book.calibration().ThresholdOf(of.suspects);
  };
  const double more = threshold(hypothesis) - threshold(standing);
  if (more > 0.0 && hypothesis.gain - standing.gain > task.options.beyond_doubt * more) return true;
  const StructureFit& baseline = book.baseline().fit;
  const StructureFit refit = FitStructure(task.data,
                                          hypothesis.fit.model,
                                          hypothesis.fit.initial,
                                          Whitener(baseline.noise, task.data.samples()));
  return baseline.chi_squared - refit.chi_squared >
         task.options.least_under_the_baselines_noise *
             static_cast<double>(hypothesis.suspects.size());
}

// A fit under another noise, where that is likelier.
StructureFit LikelierUnder(const SearchTask& task,
                           const StructureFit& fit,
                           const NoiseModel& noise) {
  StructureFit other =
      FitBy(task.options.criterion, task.data, fit, {&noise, 1}, task.options.precision);
  return other.IsUsable() && other.log_likelihood > fit.log_likelihood ? other : fit;
}

// The book with what stands, and all else, under the noise of what is better, where what stands is
// likelier under it. A gain has to come of a cause, and the likelihood of a noise has maxima of its
// own.
HypothesisBook WithOneNoise(const SearchTask& task, int size, HypothesisBook book) {
  constexpr int kMostRounds = 3;
  if (task.options.criterion == Criterion::kFreeRun) return book;
  for (int round = 0; round < kMostRounds; ++round) {
    const std::vector<int> ranked = book.RankedOfSize(size);
    if (ranked.empty() || !(book.Worth(ranked.front()) > book.Worth(book.best()))) break;
    const NoiseModel noise = book[ranked.front()].fit.noise;
    const StructureFit& standing = book[book.best()].fit;
    const double gained =
        LikelierUnder(task, standing, noise).log_likelihood - standing.log_likelihood;
    if (!(gained > task.options.of_noise)) break;
    std::vector<StructureFit> fits(static_cast<std::size_t>(book.size()));
    ParallelFor(book.size(), [&](int i) {
      fits[static_cast<std::size_t>(i)] = LikelierUnder(task, book[i].fit, noise);
    });
    for (int i = 0; i < book.size(); ++i) {
      Hypothesis hypothesis = {book[i].suspects, std::move(fits[static_cast<std::size_t>(i)])};
      book.Replace(
          i,
          i == 0 ? std::move(hypothesis) : Weighed(task, book.baseline(), std::move(hypothesis)));
    }
  }
  return book;
}

}  // namespace

SearchResult SearchCauses(const TrainingData& data,
                          const StructureFit& baseline,
                          const std::vector<Suspect>& suspects,
                          const DiagnosisOptions& wanted,
                          const SearchOptions& options,
                          const EndsSearch& ends) {
  SearchTask task = {data, suspects, wanted, options};
  const auto about_baseline = WithTrials(task, baseline);
  const Screens screens =
      ScreensAbout(task, about_baseline, baseline.noise, Sharpness::kWithSensor);
  std::vector<double> scores(suspects.size(), 0.0);
  for (int k = 0; screens.own && k < task.num_suspects(); ++k) scores[k] = screens.own->Score(k);

  HypothesisBook book(baseline, CalibrationOf(task, screens));
  std::vector<int> beam;
  bool is_cut = false;
  for (int size = 1; size <= wanted.most_causes; ++size) {
    task.begun = data.work();
    if (size == 1) book = WithSingles(task, screens, std::move(book));
    if (size == 1 && options.criterion == Criterion::kFreeRun) {
      book = WithSinglesByMomentum(task, std::move(book));
    }
    book = WithOneMoreEach(task, beam, std::move(book));
    if (size == 2 && !task.IsSpent()) book = WithPairs(task, about_baseline, std::move(book));
    book = WithOneNoise(task, size, std::move(book));
    const std::vector<int> ranked = book.RankedOfSize(size);
    const bool is_better = !ranked.empty() && book.Worth(ranked.front()) > book.Worth(book.best());
    if (is_better && HoldsUnderTheBaselinesNoise(task, book, book[ranked.front()])) {
      book.SetBest(ranked.front());
      book = Challenged(task, about_baseline, std::move(book));
    }
    is_cut = is_cut || task.IsSpent();
    if (!is_better && size >= 2) break;
    if (size < wanted.most_causes && ends(book, size)) break;
    beam = CarriedOn(task, book, size);
  }
  return {std::move(book), is_cut, std::move(scores)};
}

}  // namespace fathom
