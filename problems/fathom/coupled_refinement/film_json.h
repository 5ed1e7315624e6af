// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled_refinement/film_refinement.h"

#include <optional>
#include <string>

namespace fathom {

// A usable refinement as JSON, schema "fathom-film-refinement-1": docs/file_formats.md. `path`: how
// far the paths are from the true one, where that is known.
std::string FormatFilmRefinementJson(const FilmRefinement& refinement,
                                     const std::optional<PathErrors>& path = {});

}  // namespace fathom
