// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <string>
#include <vector>

#include "score.h"

namespace fathom::hidden {

// Outcomes over a set of logs.
struct Tally {
  int logs = 0;
  std::array<int, kNumOutcomes> outcomes{};

  void Add(const LogScore& score);
  int Of(Outcome outcome) const { return outcomes[static_cast<int>(outcome)]; }
  // Named alone or as a member of an honestly reported group.
  int Named() const { return Of(Outcome::kAlone) + Of(Outcome::kGroup); }
};

// One effect, hidden alone.
struct EffectRow {
  std::string effect;
  int clear = 0, separable = 0;  // both of `separable`
  Tally all, separable_tally;
  Coverage effect_parameters, model_parameters;
};

// The figures that the bars are about.
struct ScoreBoard {
  std::vector<EffectRow> effects;  // in the order of the catalogue, those hidden alone in some log
  Tally separable_one, separable_two;  // clear and separable
  Tally all_one, all_two, unlisted;

  int nothing = 0;       // logs with nothing hidden
  int false_causes = 0;  // any cause named, certain or not
  int false_certain_causes = 0;
  int not_consistent = 0;    // any verdict but `consistent`
  int unlisted_clear = 0;    // the true structure beats the baseline by 30
  int unlisted_certain = 0;  // a certain cause of the catalogue
  int unlisted_clear_certain = 0;
  int unlisted_clear_unseen = 0;  // verdict `consistent` although clear

  // Over clear logs with data held out of which the oracle gains over 2 %: gain reached / oracle's.
  std::vector<double> gain_ratios;
  double MedianGainRatio() const;  // NaN: none

  Coverage effect_parameters, model_parameters;  // one effect, named alone
  Coverage null_model_parameters;                // nothing hidden, nothing named

  double diagnosis_seconds = 0.0, slowest_diagnosis = 0.0, oracle_seconds = 0.0;
};

ScoreBoard BoardOf(const std::vector<LogScore>& scores);

}  // namespace fathom::hidden
