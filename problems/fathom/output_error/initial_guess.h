// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/signal/signals.h"
#include "fathom/vehicle/uncoupled_model.h"

#include <span>
#include <string>

namespace fathom {

// Where output error starts its search.
struct InitialGuess {
  UncoupledModel<double> model;
  std::string family;  // "least_squares", "adaptive" or "rough"
};

// Least squares, and where that is unusable or its free run misses more than half of the motion
// also the adaptive law: whichever free run comes closer. If neither can be simulated, a rough
// guess of the right order of magnitude. Always physical: positive inertia, dampings at least 0.
InitialGuess ChooseInitialGuess(std::span<const Segment> segments);

}  // namespace fathom
