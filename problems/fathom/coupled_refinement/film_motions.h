// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled_refinement/coupled_film.h"
#include "fathom/coupled_refinement/window_motion.h"

#include <cstddef>
#include <vector>

namespace fathom {

// The simulated motion of each window, at the unknowns last given.
class FilmMotions {
 public:
  // `film` must outlive this.
  explicit FilmMotions(const CoupledFilm& film);

  // Simulates all windows. False if one diverges.
  bool Update(const FilmUnknowns& unknowns, bool with_derivatives);

  const WindowMotion& at(std::size_t window) const { return motions_[window]; }
  bool is_valid(std::size_t window) const { return is_valid_[window] != 0; }

 private:
  std::vector<WindowMotion> motions_;
  std::vector<char> is_valid_;
};

}  // namespace fathom
