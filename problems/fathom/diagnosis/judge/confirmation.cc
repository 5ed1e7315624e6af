// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/judge/confirmation.h"

#include "fathom/diagnosis/fit/fit_with_noise.h"
#include "fathom/diagnosis/fit/other_minima.h"
#include "fathom/diagnosis/fit/start_price.h"

#include <utility>

namespace fathom {
namespace {

StructureFit FitToAll(const TrainingData& data, const WeighedSearch& search, int index) {
  const StructureFit& rough = search.found.book[index].fit;
  StructureFit fit = FitBy(search.criterion, data, rough.model, rough.initial, rough.noise);
  if (search.criterion == Criterion::kFreeRun) return fit;
  return LikeliestMinimum(data, std::move(fit));
}

}  // namespace

const StructureFit& FitOf(const HypothesisBook& book, const Choice& choice, int index) {
  const auto found = choice.fits.find(index);
  return found == choice.fits.end() ? book[index].fit : found->second;
}

Choice ConfirmedOnAllData(const TrainingData& data, const WeighedSearch& search) {
  const StructureFit& baseline = search.baseline;
  const HypothesisBook& book = search.found.book;
  std::map<int, StructureFit> fits = {{0, baseline}};
  const auto fit_of = [&](int index) -> const StructureFit& {
    if (const auto found = fits.find(index); found != fits.end()) return found->second;
    return fits[index] = FitToAll(data, search, index);
  };
  const auto worth = [&](int index) {
    return 2.0 * (fit_of(index).log_likelihood - baseline.log_likelihood) -
           PriceOfStarts(data, fit_of(index).start_gains) -
           book.calibration().ThresholdOf(book[index].suspects);
  };
  int best = book.best();
  for (bool is_settled = false; !is_settled;) {
    is_settled = true;
    const int challenged = best;
    for (const int suspect : book[challenged].suspects) {
      const int without = book.IndexWithout(challenged, suspect);
      if (without < 0 || !IsPhysical(book[without])) continue;
      if (worth(without) < worth(best)) continue;
      best = without;
      is_settled = false;
    }
  }
  if (!fit_of(best).IsUsable()) best = 0;
  Choice choice = {best, {{0, baseline}}};
  choice.fits[best] = fit_of(best);
  return choice;
}

Choice WithChosen(const TrainingData& data, const WeighedSearch& search, int index, Choice choice) {
  if (!choice.fits.contains(index)) {
    StructureFit fit = FitToAll(data, search, index);
    if (fit.IsUsable()) {
      choice.fits[index] = std::move(fit);
    } else {
      index = 0;
    }
  }
  choice.chosen = index;
  return choice;
}

}  // namespace fathom
