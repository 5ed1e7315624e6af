// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/log/log.h"
#include "fathom/vehicle/uncoupled_model.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// The model that a user has, and its covariance.
struct IdentifiedModel {
  UncoupledModel<double> model;
  Eigen::MatrixXd covariance;
};

// What there is to say of it, and why there is none.
struct Identified {
  std::optional<IdentifiedModel> model;
  std::vector<std::string> remarks;  // on runs that differ, a sentence each
  std::string why_none;              // as fathom_identify says it; empty where there is a model
};

// What fathom_identify gives for these logs by default: output error on the best source; of several
// logs with intervals as wide as these differ.
Identified IdentifiedModelOf(std::span<const Log> logs, Dof dof);

}  // namespace fathom
