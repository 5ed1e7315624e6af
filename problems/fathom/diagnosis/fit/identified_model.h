// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/log/log.h"
#include "fathom/vehicle/uncoupled_model.h"

#include <optional>
#include <span>

#include <Eigen/Core>

namespace fathom {

// The model that a user has, and its covariance.
struct IdentifiedModel {
  UncoupledModel<double> model;
  Eigen::MatrixXd covariance;
};

// What fathom_identify gives for these logs by default: output error on the best source, with the
// weighting that it chooses. Nothing if that is not usable.
std::optional<IdentifiedModel> IdentifiedModelOf(std::span<const Log> logs, Dof dof);

}  // namespace fathom
