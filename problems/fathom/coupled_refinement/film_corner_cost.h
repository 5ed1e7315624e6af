// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled_refinement/film_motions.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace ceres {
class CostFunction;
}

namespace fathom {

// Reprojection of one detection of a film, whitened. Blocks: the deviation of the frame (if any
// DOF has one), what all windows share, the start of the window. Borrows all but the numbers.
struct FilmCornerCostOf {
  const CoupledFilm& film;
  const FilmMotions& motions;
  const std::vector<int>& moving;  // the DOFs with deviations
  double corner_sigma;             // [px]
  std::size_t window, frame;
  const Detection& detection;
};

std::unique_ptr<ceres::CostFunction> MakeFilmCornerCost(const FilmCornerCostOf& of);

}  // namespace fathom
