// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled/entry_prior.h"
#include "fathom/coupled/fitted_channel.h"
#include "fathom/coupled/row_whitener.h"
#include "fathom/simulate/coupled/coupled_data.h"
#include "fathom/vehicle/coupled/coupled_model.h"
#include "fathom/vehicle/coupled/free_entry.h"

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// What a fit took the residuals of one channel for.
struct ChannelNoise {
  FittedChannel channel;
  RowWhitener whitener;
};

// Numbers that were not computed are NaN, never zero.
struct CoupledSummary {
  // True if the search converged to a model that the data determine.
  bool IsUsable() const { return converged && determined; }

  std::string message = "FitCoupled() was not called.";
  bool converged = false;
  bool determined = false;

  CoupledModel model;
  std::vector<FreeEntry> entries;
  Eigen::MatrixXd covariance;            // of the entries, in their order
  std::vector<FreeEntry> on_bound;       // pressed against what keeps the model physical
  std::vector<FreeEntry> open_inertias;  // of a DOF, that may be 0 as far as the data tell
  std::vector<FreeEntry>
      undetermined;  // that trade against each other without a trace, or may be 0

  std::vector<EntryPrior> priors;  // that held entries which the data leave open

  std::vector<CoupledState> starts;  // of the windows, in their order
  std::vector<ChannelNoise> noise;

  // By Index(Dof), of what FitOutputError() fitted by itself, whose noise stands in no channel: the
  // colour of its residual over samples, phi_1 ... of docs/output_error.md (5).
  std::array<std::optional<std::vector<double>>, 6> colour_of_uncoupled;

  double cost = std::numeric_limits<double>::quiet_NaN();  // half the sum of weighed squares
  int num_rows = 0;
  int num_iterations = 0;
};

}  // namespace fathom
