// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_refinement/film_motions.h"

namespace fathom {

FilmMotions::FilmMotions(const CoupledFilm& film) : is_valid_(film.windows.size(), 0) {
  for (std::size_t w = 0; w < film.windows.size(); ++w) motions_.emplace_back(film, w);
}

bool FilmMotions::Update(const FilmUnknowns& unknowns, bool with_derivatives) {
  bool all = true;
  for (std::size_t w = 0; w < motions_.size(); ++w) {
    const bool runs = motions_[w].Update(unknowns, with_derivatives);
    is_valid_[w] = runs ? 1 : 0;
    all = all && runs;
  }
  return all;
}

}  // namespace fathom
