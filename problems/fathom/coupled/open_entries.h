// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled/coupled_summary.h"
#include "fathom/vehicle/coupled/free_entry.h"
#include "fathom/vehicle/coupled/rigid_body.h"

#include <vector>

#include <Eigen/Core>

// What the data of a fit leave open. `summary`: with its model and entries.

namespace fathom {

// The entries that trade against each other: those of directions without a trace in the `normal`
// equations.
std::vector<FreeEntry> UndeterminedIn(const Eigen::MatrixXd& normal,
                                      const std::vector<FreeEntry>& entries);

// The inertias among the undetermined entries, but for the one whose share of itself the residuals
// feel most: with that one known, the others are told.
std::vector<FreeEntry> OpenBesideTheBestTold(const CoupledSummary& summary,
                                             const Eigen::MatrixXd& normal);

// Inertias of DOFs whose 95 % interval reaches 0, but for those that a prior holds. With the
// covariance.
std::vector<FreeEntry> InertiasThatMayBe0(const CoupledSummary& summary);

// Entries whose own bound the search leans on. With the covariance.
std::vector<FreeEntry> OnBound(const CoupledSummary& summary, const RigidBody& body);

}  // namespace fathom
