// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled/unseen_errors.h"
#include "fathom/simulate/coupled/coupled_prediction.h"

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace fathom {

// One structure, or one family's models of one DOF each. Numbers that are not known are NaN.
struct StructureRow {
  std::string name;  // "full", "auto"; of models of one DOF each "output_error", "best"
  bool is_of_one_dof = false;
  std::string chosen = {};                    // of auto: the ladder's rung
  std::vector<std::string> of_families = {};  // of "best", by DOF: whose model is the best

  bool is_usable = false;
  std::string message = {};  // why not, of the first DOF that is not

  std::size_t num_numbers = 0;  // that are free

  // By Index(Dof). Free runs over the data of the fit, and over what is held out, begun anew after
  // every CoupledFitOptions::window; then those of 5 s over data that were not fitted, of fits of
  // the rest: UnseenErrorsOf().
  std::array<double, 6> train_nmae, held_out_nmae, unseen_nmae;

  // How much nearer the runs over unseen data are than those of StructureComparison::Best(), and
  // than those of Taken(). Absent where that is not known, and of these rows themselves.
  std::optional<UnseenGain> gain = {}, gain_over_taken = {};

  // What it takes to fit all training data [s]; of auto, all of the ladder.
  double seconds = std::numeric_limits<double>::quiet_NaN();

  CoupledPrediction prediction = {};  // where usable
};

}  // namespace fathom
