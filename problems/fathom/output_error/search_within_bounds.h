// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/output_error/options.h"
#include "fathom/output_error/shooting_window.h"
#include "fathom/solve/solve_with_bounds.h"
#include "fathom/vehicle/parameters.h"
#include "fathom/vehicle/uncoupled_model.h"

#include <array>
#include <vector>

namespace fathom {

// What the search moves. The inertia is carried as its logarithm, so it stays positive.
struct WindowUnknowns {
  std::array<double, kNumParameters> parameters = {};
  std::vector<std::array<double, 2>> states;  // of each window: velocity, position
};

UncoupledModel<double> ModelOf(const WindowUnknowns& unknowns);

struct ConstrainedOptimum {
  BoundedSolve solve;
  WindowUnknowns unknowns;  // where it began, if it did not converge
};

// The least cost with both dampings at least 0, from `start`; `sigma` and `huber_k` as in
// ShootingWindow.
ConstrainedOptimum SearchWithinBounds(const std::vector<ShootingWindow>& windows,
                                      double sigma,
                                      double huber_k,
                                      const OutputErrorOptions& options,
                                      const WindowUnknowns& start);

}  // namespace fathom
