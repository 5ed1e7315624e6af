// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled_refinement/coupled_film.h"
#include "fathom/joint_refinement/processes/process_set.h"

#include <limits>
#include <string>

namespace fathom {

// The DOF whose deviation is free motion under random force, docs/joint_refinement.md (5): the
// first modelled one. All others wander by (4).
int FreelyMoving(const CoupledFilm& film);

struct FilmSolveOptions {
  int max_iterations = 50;   // above 0
  double loss_limit = 26.1;  // JointOptions::loss_limit
  bool is_far = false;       // far detections count linearly, so that a poor start finds its way
};

struct FilmSolve {
  bool converged = false;
  std::string message;
  int num_iterations = 0;
  double initial_cost = std::numeric_limits<double>::quiet_NaN();
  double cost = std::numeric_limits<double>::quiet_NaN();
};

// The one Ceres problem: the entries, the trim, the starts of the windows and the deviations of the
// frames, over all corners, under given processes and the barrier of docs/coupled.md (7).
FilmSolve SolveFilm(const CoupledFilm& film,
                    const ProcessSet& processes,
                    const FilmSolveOptions& options,
                    FilmUnknowns* unknowns);

}  // namespace fathom
