// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/search/challenge.h"

#include "fathom/diagnosis/search/refinement.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace fathom {
namespace {

constexpr double kBetter = 1e-9;  // worth by which one is better than another and not its equal

// The book with the hypothesis without one of its causes, which are several, on from its own fit.
HypothesisBook WithoutOne(const SearchTask& task,
                          const Hypothesis& hypothesis,
                          int cause,
                          HypothesisBook book) {
  const StructureFit& fit = hypothesis.fit;
  const StructureFit rough =
      FitStructure(task.data,
                   WithoutEffect(fit.model, EffectPlace(task, fit.model, cause)),
                   fit.initial,
                   Whitener(fit.noise, task.data.samples()),
                   task.options.rough);
  if (!rough.IsSimulated()) return book;
  constexpr double kWhateverItGains = -std::numeric_limits<double>::infinity();
  Hypothesis without = BegunFrom(task,
                                 book.baseline(),
                                 hypothesis,
                                 Without(hypothesis.suspects, cause),
                                 rough,
                                 kWhateverItGains);
  return WithSettled(task, {std::move(without)}, kWhateverItGains, std::move(book));
}

// The book with what may stand in for one cause of a hypothesis beside the others, `base`.
HypothesisBook WithRivals(const SearchTask& task,
                          const Screens& screens,
                          const Hypothesis& base,
                          const Hypothesis& challenged,
                          int cause,
                          HypothesisBook book) {
  const SearchOptions& options = task.options;
  const double least = options.rival_share * screens.scores[cause] - options.rival_slack;
  std::vector<int> suspects;
  for (const int suspect : InOrder(screens.scores)) {
    const double score = screens.scores[suspect];
    if (score < least || score < options.worth_refining) break;
    if (std::ssize(suspects) == options.most_rivals) break;
    if (!challenged.Has(suspect)) suspects.push_back(suspect);
  }
  return Refined(task, screens, base, suspects, std::move(book));
}

// The book with a hypothesis refitted without one cause, and with what may stand in for it.
HypothesisBook WithCauseReplaced(const SearchTask& task,
                                 const std::shared_ptr<const FitAndTrials>& baseline,
                                 const Hypothesis& challenged,
                                 int cause,
                                 HypothesisBook book) {
  if (challenged.suspects.size() > 1) {
    book = WithoutOne(task, challenged, cause, std::move(book));
  }
  const int index = book.IndexOf(Without(challenged.suspects, cause));
  if (index < 0) return book;
  const Hypothesis base = book[index];
  // Under the noise that the challenged one leaves, rivals stand out as they should.
  const Screens screens = ScreensAbout(task,
                                       index == 0 ? baseline : WithTrials(task, base.fit),
                                       challenged.fit.noise,
                                       Sharpness::kOwn);
  if (!screens.own) return book;
  return WithRivals(task, screens, base, challenged, cause, std::move(book));
}

}  // namespace

HypothesisBook Challenged(const SearchTask& task,
                          const std::shared_ptr<const FitAndTrials>& baseline,
                          HypothesisBook book) {
  for (int round = 0; round < task.options.most_rounds; ++round) {
    const int index = book.best();
    const Hypothesis challenged = book[index];
    for (const int cause : challenged.suspects) {
      if (task.IsSpent()) break;
      book = WithCauseReplaced(task, baseline, challenged, cause, std::move(book));
    }
    const int num_causes = static_cast<int>(challenged.suspects.size());
    for (int size = std::max(1, num_causes - 1); size <= num_causes; ++size) {
      const std::vector<int> ranked = book.RankedOfSize(size);
      if (ranked.empty()) continue;
      if (book.Worth(ranked.front()) > book.Worth(book.best()) + kBetter) {
        book.SetBest(ranked.front());
      }
    }
    if (book.best() == index) break;
  }
  return book;
}

}  // namespace fathom
