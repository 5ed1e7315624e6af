// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled_refinement/coupled_film.h"

#include <memory>

namespace ceres {
class CostFunction;
}

namespace fathom {

// The barrier of docs/coupled.md (7) as a residual of the block that all windows share: half its
// squared norm is the barrier's cost and a constant. What it returns as its Jacobian J is not the
// derivative of the residual r but what a Gauss-Newton step asks of it: J'r is the barrier's
// gradient, J'J its curvature. A point outside the bounds is refused. `film` and `model` must
// outlive it.
std::unique_ptr<ceres::CostFunction> MakeBarrierCost(const CoupledFilm& film,
                                                     const FilmUnknowns& unknowns);

}  // namespace fathom
