// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/extended_model.h"

#include <limits>
#include <string>

#include "hidden_log.h"

namespace fathom::hidden {

// What can be known of one log by somebody who knows what is hidden in it and how noisy it is.
struct OracleAnswer {
  static constexpr double kNotComputed = std::numeric_limits<double>::quiet_NaN();

  // BIC of a model less BIC of the true one, both fitted; above 0: the true one is better.
  double baseline_delta_bic = kNotComputed;
  double rival_delta_bic = kNotComputed;  // of the best rival, or of the first that is below 10
  std::string rival;                      // its label

  double chi2_per_sample = kNotComputed;  // of the true structure, fitted: about 1

  // NMAE of the velocity on data held out; NaN where there are none.
  double held_out_baseline = kNotComputed;
  double held_out_truth = kNotComputed;

  double seconds = kNotComputed;  // spent

  bool IsClear() const { return baseline_delta_bic >= 30.0; }
  bool IsSeparable() const { return rival_delta_bic >= 10.0; }
};

// Fits the baseline, the true structure and every rival to the training data: for one effect every
// other one, with every partner that moves; for two the sets with one replaced, and each alone.
// Nothing hidden: all NaN. An effect outside the catalogue has no rivals.
OracleAnswer AskOracle(const HiddenLog& hidden);

// NMAE of the velocity of `model` on the data held out, started where it fits them best: the same
// yardstick for every model. NaN where nothing is held out.
double HeldOutNmae(const HiddenLog& hidden, const ExtendedModel& model);

}  // namespace fathom::hidden
