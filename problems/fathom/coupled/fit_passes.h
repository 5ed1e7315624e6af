// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled/coupled_fit_options.h"
#include "fathom/coupled/coupled_summary.h"
#include "fathom/coupled/window_problem.h"
#include "fathom/coupled/window_residuals.h"
#include "fathom/coupled/window_search.h"

#include <vector>

namespace fathom {

// How far a search goes whose noise is not known yet.
WindowSearchOptions RoughSearch(const CoupledFitOptions& options);

// What the passes of a fit came to.
struct FitPasses {
  // The last pass that ended well; where none did, the one that did not, unconverged.
  WindowSearch best;

  std::vector<ChannelNoise> noise;  // what the best took the residuals for; empty where none did
  int num_iterations = 0;           // of all passes
};

// White noise first, unless its colour is given; then the colour of what is left, until the numbers
// stay. A colour with which the search goes astray is given up for what came before it: that of a
// model that misses much of the motion takes what is missed for noise. `residuals`: those at
// `start`, of each window.
FitPasses FitInPasses(const WindowProblem& problem,
                      const WindowPoint& start,
                      const std::vector<WindowResiduals>& residuals,
                      const CoupledFitOptions& options);

}  // namespace fathom
