// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/search/screen/screen.h"
#include "fathom/noise/whitener.h"

#include <memory>
#include <vector>

namespace fathom {

// A fitted model and every suspect at every trial about it: what screens under several noises
// share.
struct FitAndTrials {
  StructureFit fit;
  Trials trials;
};

// Where the refit of one suspect may start: a trial with the amounts that the linear screen finds.
struct Start {
  double score = 0.0;
  int trial = 0;  // index into Trials::trials
  ActiveEffect effect;
};

// The suspects beside a fitted model, as they look under one noise. Data and suspects outlive it.
class Starts {
 public:
  Starts(const TrainingData& data,
         const std::vector<Suspect>& suspects,
         std::shared_ptr<const FitAndTrials> about,
         const Whitener& whitener);

  const Trials& trials() const { return about_->trials; }
  const Screen& screen() const { return screen_; }
  const Whitener& whitener() const { return whitener_; }

  // Best score of any of the suspect's trials.
  double Score(int suspect) const;
  double BestScore() const;

  // The suspect's trials, best score first.
  const std::vector<int>& TrialsOf(int suspect) const { return by_suspect_[suspect]; }

  // What the best of them tries; the suspect has one.
  ActiveEffect BestTrialOf(int suspect) const;

  // At most `most` starts from trials that do not lie side by side, best first. A time of the run
  // is narrowed down from the grid of the trials: under coloured noise a sudden change is seen only
  // where it happened.
  std::vector<Start> Of(int suspect, int most) const;

 private:
  Start StartAt(const Trial& trial, double score, const std::vector<double>& amounts) const;
  Start NarrowedDown(int trial) const;

  const TrainingData* data_;
  const std::vector<Suspect>* suspects_;
  std::shared_ptr<const FitAndTrials> about_;
  Whitener whitener_;
  Screen screen_;
  std::vector<std::vector<int>> by_suspect_;
};

// True if the effect has a time or a frequency of the run and the two are not about the same there:
// a search from the one would not end at the other. `duration`: of the run [s].
bool IsElsewhere(const ActiveEffect& effect, const ActiveEffect& other, double duration);

}  // namespace fathom
