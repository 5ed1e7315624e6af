// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/output_error/options.h"
#include "fathom/output_error/shooting_window.h"
#include "fathom/solve/solve_with_bounds.h"
#include "fathom/vehicle/uncoupled_model.h"

#include <array>
#include <vector>

namespace fathom {

// What the search moves.
struct WindowUnknowns {
  VehicleBlock vehicle = {};
  std::vector<double> offsets;                // the buoyancy: one, or one per log
  std::vector<std::array<double, 2>> states;  // of each window: velocity, position
};

// At the start of window `w`.
InitialState StateOf(const WindowUnknowns& unknowns, std::size_t w);

// With the mean of the offsets.
UncoupledModel<double> ModelOf(const WindowUnknowns& unknowns);

// As it acts in `window`.
UncoupledModel<double> ModelIn(const ShootingWindow& window, const WindowUnknowns& unknowns);

struct ConstrainedOptimum {
  BoundedSolve solve;
  WindowUnknowns unknowns;  // where it began, if it did not converge
};

// The least cost with both dampings at least 0, from `start`; `sigma` and `huber_k` as in
// ShootingWindow.
ConstrainedOptimum FindConstrainedOptimum(const std::vector<ShootingWindow>& windows,
                                          double sigma,
                                          double huber_k,
                                          const OutputErrorOptions& options,
                                          const WindowUnknowns& start);

}  // namespace fathom
