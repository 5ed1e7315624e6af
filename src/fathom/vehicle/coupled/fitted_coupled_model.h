// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/coupled/coupled_model.h"
#include "fathom/vehicle/coupled/free_entry.h"
#include "fathom/vehicle/fitted_model.h"

#include <array>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// A model of several DOFs with what is known about its making: what a file of the schema
// "fathom-model-2" holds.
struct FittedCoupledModel {
  CoupledModel model;
  std::string structure;   // "diagonal", "coriolis", "symmetric", "full", "auto"
  std::string force_unit;  // "N", or the log's command_unit

  std::vector<FreeEntry> entries;  // the numbers that were identified
  Eigen::MatrixXd covariance;      // of them, in products of their units; NaN where not known

  // By Index(Dof), of the modelled ones: free runs begun anew from the measured state every
  // `horizon` seconds.
  double horizon = std::numeric_limits<double>::quiet_NaN();
  std::array<FitFigures, 6> train, held_out;

  // Of each DOF, the colour of the velocities that the fit misses, as it took it: phi_1 ... of
  // docs/output_error.md (5), over samples of the rate of `train`. No numbers: white. Nothing: not
  // known.
  std::array<std::optional<std::vector<double>>, 6> residual_autoregression;

  std::vector<std::string> caveats;
  std::map<std::string, std::string> provenance;
  std::vector<std::string> log_fingerprints;
};

}  // namespace fathom
