// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/vehicle/coupled/free_entry.h"
#include "fathom/vehicle/parameters.h"

#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// The joint fit over all logs of one dive: of one DOF, or of a coupled model.
struct DiveEstimate {
  int dive = 0;           // place in the order of dives, from 0
  Dof dof = Dof::kSurge;  // of one DOF
  Eigen::VectorXd value = ParameterVector::Zero();
  // NaN on the diagonal, or above any use: this parameter is not known from this dive.
  Eigen::MatrixXd covariance = ParameterCovariance::Zero();

  // As FittedModel has it; empty where the dive does not know it.
  std::map<std::string, double> thruster_shares = {};

  // What the values of a coupled model are. Empty: those of kParameterInfo along `dof`.
  std::vector<FreeEntry> entries = {};
};

}  // namespace fathom
