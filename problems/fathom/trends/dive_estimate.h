// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/vehicle/parameters.h"

#include <map>
#include <string>

namespace fathom {

// The joint fit of one DOF over all logs of one dive.
struct DiveEstimate {
  int dive = 0;  // place in the order of dives, from 0
  Dof dof = Dof::kSurge;
  ParameterVector value = ParameterVector::Zero();
  // NaN on the diagonal, or above any use: this parameter is not known from this dive.
  ParameterCovariance covariance = ParameterCovariance::Zero();

  // As FittedModel has it; empty where the dive does not know it.
  std::map<std::string, double> thruster_shares = {};
};

}  // namespace fathom
