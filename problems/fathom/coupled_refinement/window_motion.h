// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled_refinement/coupled_film.h"
#include "fathom/geometry/pose_increment.h"

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// Where the model takes a vehicle during a window, at each frame: docs/coupled.md (1), one
// simulation for all frames, with its sensitivities.
class WindowMotion {
 public:
  // `film` must outlive this.
  WindowMotion(const CoupledFilm& film, std::size_t window);

  // Simulates. False if it diverges; the poses then mean nothing.
  bool Update(const FilmUnknowns& unknowns, bool with_derivatives);

  // Of frame `k`: world_from_body as simulated.
  const Pose& PoseAt(std::size_t k) const { return poses_[k]; }

  // d PoseIncrement of that pose / d (what is shared, step of the start): num_shared() and
  // num_start() columns. Needs an update with derivatives.
  using Derivatives = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::RowMajor>;
  const Derivatives& DerivativesAt(std::size_t k) const { return derivatives_[k]; }

  int num_shared() const { return num_shared_; }
  int num_start() const { return num_start_; }

 private:
  const CoupledFilm& film_;
  std::size_t window_;
  // Where each column of the derivatives comes from: among those of the simulation, which has all
  // three turns and no position.
  std::vector<Eigen::Index> source_;
  std::vector<int> trim_, turns_;  // axes, of 0 to 2, that all windows and that this one turn about
  int num_shared_, num_start_;
  std::vector<Pose> poses_;
  std::vector<Derivatives> derivatives_;
};

}  // namespace fathom
