// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/fit/criterion.h"

namespace fathom {

// How widely causes are searched. Scores and gains are twice a log-likelihood.
struct SearchOptions {
  // TrainingData::work() after which the search for one cause more ends with what it has, for
  // wanted.effort = 1: of five minutes of data, and of so many times five minutes by the root of
  // that. Logs that some model fits take a tenth; where none does, every hypothesis gains and each
  // one's fit is slow.
  double most_work = 4e7;

  // What fits are weighed by.
  Criterion criterion = Criterion::kLearnedNoise;

  // Of free runs: how many of the samples count, since what is missing makes neighbours alike.
  double effective_share = 1.0;

  // Draws of what noise alone reaches, behind the thresholds: quantiles of 0.9 have 50 beyond them.
  int null_draws = 512;

  // Hypotheses of each size that one more cause is added to: the true pair's halves may rank second
  // and third alone.
  int beam = 3;

  // Suspects refitted about the baseline, and about a hypothesis with causes, of which there are
  // `beam` for each size: a refit with its noise is what takes the time.
  int most_refined = 10;
  int most_refined_beside = 4;

  // Suspects refitted from where the momentum along the measured motion puts them.
  int most_from_momentum = 8;

  // Starts of a suspect with more than amounts to look for, from which its error may end in
  // different minima; one that has amounts alone has one minimum.
  int most_starts = 2;

  // A first fit is near enough to choose from, and a fit with its noise to rank by: thresholds are
  // above 10.
  FitPrecision rough = {.share = 1e-3};
  FitPrecision precision = {.gain = 0.1, .turn = 0.5};

  // Of the greatest gain so far: a hypothesis that gains less under its first noise is left at
  // that.
  double hope = 0.5;

  // Of the same: what gains more has its noise learned from nothing too.
  double contends = 0.9;

  // What a refit may gain, in scores and in what those before it gained of theirs, where it is
  // weighed before it is made; and what it gains at least, of its score, where it did not go
  // astray.
  double optimism = 2.0;
  double kept = 0.8;

  // Of the best hypothesis's gain, below which one of a single cause, or of several, gets no more
  // causes: those that are missing beside it would have to gain the rest.
  double least_share = 0.3;
  double least_share_of_several = 0.7;

  // Score below which nothing can come of a refit: about what BIC asks for one parameter.
  double worth_refining = 5.0;

  // The same beside other causes, of the threshold: screens are linear and may fall short.
  double worth_refining_beside = 0.5;

  // The sharper screen is scaled to the strongest score of the other, or to this where that is
  // less: its own scores count structure as certain.
  double sharpest = 12.0;

  // The draws know the noise. A fit learns it along, and finds more than they do: how much more is
  // measured on logs with nothing hidden, docs/diagnosis.md (7).
  double caution_of_learned_noise = 8.0;

  // A fit finds the best time or frequency, not the best of the grid.
  double caution_between_the_grid = 2.0;

  // Another axis' columns are in every log, whether they have to do with this axis or not.
  double caution_with_a_partner = 50.0;

  // Two fits whose residuals differ by less chi squared are one: the noise lets nobody see it.
  double alike = 0.1;

  // Standard deviations of the inertia, in inertias, from which on a fit leaves it open.
  double open_inertia = 3.0;

  // Pairs that are refitted because they only together explain much, and trials of each suspect
  // that they are made of, by each screen.
  int most_pairs = 4;
  int trials_in_pairs = 2;

  // Chi squared that each cause must gain under the noise learned without it; not asked where the
  // gain over what stands is `beyond_doubt` times the threshold of what is more.
  double least_under_the_baselines_noise = 4.0;
  double beyond_doubt = 3.0;

  // Log-likelihood that what stands has to gain by the noise of what is better, to be taken with
  // it.
  double of_noise = 2.0;

  // Rounds in which the best hypothesis is challenged, unless it stands before.
  int most_rounds = 3;

  // Beside a challenged cause a rival is refitted that scores this share of it less the slack,
  // which is for screens being linear.
  double rival_share = 0.6;
  double rival_slack = 40.0;
  int most_rivals = 6;
};

}  // namespace fathom
