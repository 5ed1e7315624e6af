// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/fit/structure_fit.h"
#include "fathom/noise/whitener.h"

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// What is tried: an effect with its partner, and the log that it acts in alone, if so.
struct Suspect {
  const Effect* effect = nullptr;
  EffectSetting setting;
};

// An effect at certain values, and what it adds to the outputs. An effect of several amounts (the
// two of `periodic_force`) has a column for each.
struct Trial {
  int suspect = 0;             // index
  std::vector<double> values;  // all the effect's parameters; amounts at their probes
  std::vector<int> amounts;    // which parameter each column probes
  bool any_sign = false;       // true: the amount may as well be negative
  int first_column = 0;
  int num_columns = 1;
};

// Every suspect at every trial about one fitted model, by simulation or, for forces in the water,
// by the linearised response.
struct Trials {
  std::vector<Trial> trials;
  RowMajorMatrix signatures;  // rows: bins
};

Trials TrialsAbout(const TrainingData& data,
                   const StructureFit& fit,
                   const std::vector<Suspect>& suspects);

// True if the effect has a frequency of the run and it is that of a single tone which the command
// is: then it cannot be told from an answer that comes early or late, and nothing is to be said
// of it.
bool IsAtTheCommandsTone(const TrainingData& data,
                         const EffectInfo& info,
                         const std::vector<double>& values);

// The trial's suspect at times of the run between this trial's and its neighbours'; none if it has
// no such time.
Trials TrialsNear(const TrainingData& data,
                  const StructureFit& fit,
                  const std::vector<Suspect>& suspects,
                  const Trial& trial);

// The same columns under one noise: whitened, cleared of what the fitted model can imitate, and of
// length 1 (orthogonal within a trial); docs/diagnosis.md (4).
class Screen {
 public:
  Screen(const StructureFit& fit, const Trials* trials, const Whitener& whitener);

  // By how much chi squared would fall, linearly, for each trial; 0 where the sign is wrong.
  const std::vector<double>& scores() const { return scores_; }

  // The trial's amounts that the linear screen finds, in units of its probes.
  const std::vector<std::vector<double>>& amounts() const { return amounts_; }

  // Share of the signature that the fitted model cannot imitate.
  const std::vector<double>& surviving_shares() const { return surviving_shares_; }

  // Score of two trials taken together.
  double PairScore(int a, int b) const;

  // Draws of each suspect's greatest score where nothing is missing: a row per draw, a column per
  // suspect.
  Eigen::MatrixXd NullMaxima(int num_draws, int num_suspects, std::uint64_t seed) const;

 private:
  const Trials* trials_;
  Eigen::MatrixXd unit_;       // rows: bins
  Eigen::VectorXd projected_;  // unit' residual
  std::vector<double> scores_, surviving_shares_;
  std::vector<std::vector<double>> amounts_;
};

}  // namespace fathom
