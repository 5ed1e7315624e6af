// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/search/pairs.h"

#include "fathom/base/parallel_for.h"
#include "fathom/diagnosis/search/refinement.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace fathom {
namespace {

// Two suspects at the trials that explain most together.
struct Pair {
  double score = 0.0;
  int a = 0, b = 0;
  int trial_a = -1, trial_b = -1;
};

// The best trials of a suspect on both screens.
std::vector<int> BestTrials(const SearchTask& task, const Screens& screens, int suspect) {
  std::vector<int> best;
  for (const auto* starts : {&screens.own, &screens.sharp}) {
    if (!*starts) continue;
    const std::vector<int>& own = (*starts)->TrialsOf(suspect);
    const auto count = std::min<size_t>(own.size(), task.options.trials_in_pairs);
    best.insert(best.end(), own.begin(), own.begin() + static_cast<std::ptrdiff_t>(count));
  }
  return best;
}

// Every pair that explains anything, the best first.
std::vector<Pair> RankedPairs(const SearchTask& task, const Screens& screens) {
  std::vector<int> trials, first = {0};  // of all suspects; where those of one begin
  for (int k = 0; k < task.num_suspects(); ++k) {
    const std::vector<int> own = BestTrials(task, screens, k);
    trials.insert(trials.end(), own.begin(), own.end());
    first.push_back(static_cast<int>(trials.size()));
  }
  const Eigen::MatrixXd scores = screens.own->screen().PairScores(trials);
  std::vector<Pair> pairs;
  for (int a = 0; a < task.num_suspects(); ++a) {
    for (int b = a + 1; b < task.num_suspects(); ++b) {
      Pair best;
      for (int i = first[a]; i < first[a + 1]; ++i) {
        for (int j = first[b]; j < first[b + 1]; ++j) {
          if (scores(i, j) > best.score) best = {scores(i, j), a, b, trials[i], trials[j]};
        }
      }
      if (best.trial_a >= 0) pairs.push_back(best);
    }
  }
  std::stable_sort(
      pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.score > b.score; });
  return pairs;
}

// The baseline with both suspects at their trials.
ExtendedModel ModelWith(const Pair& pair, const SearchTask& task, const FitAndTrials& baseline) {
  ExtendedModel model = baseline.fit.model;
  for (const int trial : {pair.trial_a, pair.trial_b}) {
    const Trial& at = baseline.trials.trials[trial];
    const Suspect& suspect = task.suspects[at.suspect];
    model = WithEffect(std::move(model), {suspect.effect, suspect.setting, at.values});
  }
  return model;
}

int BestSingle(const HypothesisBook& book) {
  int best = 0;
  for (const int index : book.RankedOfSize(1)) {
    if (book[index].gain > book[best].gain) best = index;
  }
  return best;
}

}  // namespace

HypothesisBook WithPairs(const SearchTask& task,
                         const std::shared_ptr<const FitAndTrials>& baseline,
                         HypothesisBook book) {
  const int single = BestSingle(book);
  const NoiseModel noise = book[single].fit.noise;
  const Screens screens = ScreensAbout(task, baseline, noise, Sharpness::kWithSensor);
  if (!screens.own) return book;
  std::vector<Pair> pairs = RankedPairs(task, screens);
  pairs.resize(std::min<size_t>(pairs.size(), task.options.most_pairs));
  const auto& calibration = book.calibration();
  // None knows of another's gain, whatever the number of threads.
  const double most_gain = book.MostGain();
  std::vector<Hypothesis> found(pairs.size());
  ParallelFor(static_cast<int>(pairs.size()), [&](int i) {
    const Pair& pair = pairs[i];
    if (pair.score < calibration.ThresholdOf({pair.a, pair.b})) return;
    // As much as one suspect alone, and what noise adds to it.
    const double least =
        screens.own->BestScore() +
        task.options.worth_refining_beside *
            std::min(calibration.thresholds_beside[pair.a], calibration.thresholds_beside[pair.b]);
    if (pair.score < least) return;
    const StructureFit rough = FitStructure(task.data,
                                            ModelWith(pair, task, *baseline),
                                            baseline->fit.initial,
                                            screens.own->whitener(),
                                            task.options.rough);
    if (!rough.IsSimulated()) return;
    found[i] = BegunFrom(task, book.baseline(), book[single], {pair.a, pair.b}, rough, most_gain);
  });
  return WithSettled(task, std::move(found), most_gain, std::move(book));
}

}  // namespace fathom
